using System.Globalization;

namespace RayTracer.Jobs.Tests;

public class MachineTests
{
    [Theory]
    [InlineData("processor\t: 0\nvendor_id\t: AuthenticAMD\ncpu family\t: 26\nmodel\t\t: 2\nmodel name\t: AMD EPYC\n\nprocessor\t: 1\nmodel\t\t: 3\n", "AMD EPYC, family 26, model 2")]
    [InlineData("processor\t: 0\nmodel name\t: Cortex-A76\n", "Cortex-A76")]
    [InlineData("processor\t: 0\nCPU implementer\t: 0x41\n", "unknown")]
    public void A_processor_is_named_with_its_class(string processors, string expected) => Assert.Equal(expected, Machine.NameIn(processors));

    [Fact]
    public void A_machine_says_which_day_it_is_and_how_wide_its_vectors_are()
    {
        string text = new Machine("Abacus", "0.5").ToString();
        Assert.StartsWith($"date: {DateTime.UtcNow.Year.ToString(CultureInfo.InvariantCulture)}-", text, StringComparison.Ordinal);
        Assert.Contains("processor: Abacus; processors: ", text, StringComparison.Ordinal);
        Assert.Contains("load before: 0.5; vector lanes: ", text, StringComparison.Ordinal);
        Assert.NotEqual("unknown", Machine.Now().Processor);
    }
}
