using System.Text.Json;

namespace RayTracer.Cli.Tests;

/// <summary>Covers <c>raytracer selftest</c> on the classes of a student, one of which is wrong, and on those of a plug-in for the fast edition.</summary>
public sealed class SelfTestVerbTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void The_wrong_class_is_named_with_the_case_and_drawn()
    {
        CliRun run = CliRun.Of("selftest", Dll("RayTracer.StudentPlugin"), "--output", _folder["report"]);
        Assert.Equal(1, run.Status);
        Assert.Contains("OwnGlossDescription (\"ownGloss\")\n  holds  all numbers are sound\n", run.Output.ReplaceLineEndings("\n"), StringComparison.Ordinal);
        Assert.Contains("WrongMatt\n", run.Output.ReplaceLineEndings("\n"), StringComparison.Ordinal);
        Assert.Contains("  FAILS  directions follow the pdf\n         0° from the normal: Samples do not follow the pdf", run.Output.ReplaceLineEndings("\n"), StringComparison.Ordinal);
        Assert.Contains("1 of 49 facts do not hold", run.Output, StringComparison.Ordinal);
        string page = File.ReadAllText(_folder["report/report.html"]);
        string drawing = Assert.Single(Directory.GetFiles(_folder["report"], "*.svg"));
        Assert.Contains(Path.GetFileName(drawing), page, StringComparison.Ordinal);
        Assert.Contains("red: too many, blue: too few", File.ReadAllText(drawing), StringComparison.Ordinal);
    }

    [Fact]
    public void Classes_of_the_fast_edition_are_tested_too_and_json_has_all_facts()
    {
        CliRun run = CliRun.Of("selftest", Dll("RayTracer.SamplePlugin"), "--json", "--seed", "5");
        Assert.Equal((0, ""), (run.Status, run.Error));
        JsonElement velvet = Assert.Single(JsonDocument.Parse(run.Output).RootElement.GetProperty("classes").EnumerateArray());
        Assert.Equal("VelvetDescription (\"velvet\")", velvet.GetProperty("name").GetString());
        Assert.True(velvet.GetProperty("holds").GetBoolean());
        Assert.Equal(7, velvet.GetProperty("facts").GetArrayLength());
    }

    [Fact]
    public void What_is_no_plug_in_is_said_so()
    {
        File.WriteAllText(_folder["a.dll"], "no assembly");
        Assert.Equal(4, CliRun.Of("selftest", _folder["a.dll"]).Status);
        CliRun run = CliRun.Of("selftest", Dll("RayTracer.Imaging"));
        Assert.Equal(4, run.Status);
        Assert.Contains("there is nothing to test", run.Error, StringComparison.Ordinal);
        Assert.Equal(2, CliRun.Of("selftest").Status);
    }

    private static string Dll(string name) => Path.Combine(AppContext.BaseDirectory, $"{name}.dll");
}
