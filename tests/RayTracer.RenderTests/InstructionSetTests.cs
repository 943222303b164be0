using System.Text.Json;
using RayTracer.Rendering;
using RayTracer.RenderTests.Bits;

namespace RayTracer.RenderTests;

/// <summary>
/// The same pictures, to the bit, whatever instructions and register widths the runtime may use and however it compiles: each
/// case is a child process with another setting of the runtime.
/// Covers `FloatW`, `LaneMath`, `RTracer` and `Denoiser`.
/// </summary>
[Trait("Category", "Thorough")]
public sealed class InstructionSetTests : IDisposable
{
    private const string Child = "RayTracer.RenderTests.dll";
    private static readonly Lazy<string[]> s_expected = new(() => [.. BitScenes.Pictures.Select(name => $"{name} {Program.Hash(name, 0)}")]);
    private readonly string _folder = Directory.CreateTempSubdirectory("raytracer-").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    // Every day one other width, and below pictures without vector instructions: each setting compiles all kernels again.
    public static TheoryData<string, string> Settings()
    {
        TheoryData<string, string> settings = new()
        {
            { "DOTNET_MaxVectorTBitWidth=128", "lanes=4" },
        };
        if (TestSettings.Thorough)
        {
            settings.Add("DOTNET_MaxVectorTBitWidth=256", "");
            settings.Add("DOTNET_MaxVectorTBitWidth=512", "");
            settings.Add("DOTNET_EnableAVX512=0 DOTNET_PreferredVectorBitWidth=128", "avx512=False");
            settings.Add("DOTNET_EnableAVX2=0 DOTNET_TieredCompilation=1", "avx2=False");
            settings.Add("DOTNET_TieredCompilation=1 DOTNET_TieredPGO=0", "");
        }

        return settings;
    }

    [Theory]
    [MemberData(nameof(Settings))]
    public void All_pictures_have_the_same_bits_with(string setting, string effect)
    {
        string[] lines = ChildProcess.Run(Child, setting, ["0", .. BitScenes.Pictures]).Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Contains(effect, lines[0], StringComparison.Ordinal);
        Assert.Equal(s_expected.Value, lines.Skip(1));
    }

    [Fact]
    [Trait("Category", "Slow")]
    public void Pictures_have_the_same_bits_without_any_vector_instructions()
    {
        // Each operation of a lane is a call then: little of each picture must do.
        string[] scenes = [.. BitScenes.Report, "everything-sobol", "everything-jittered", "meshes/02-smooth", BitScenes.Hills, "light-paths-vcm", .. BitScenes.Denoised];
        string[] lines = ChildProcess.Run(Child, "DOTNET_EnableHWIntrinsic=0", ["4", .. scenes]).Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Contains("avx2=False", lines[0], StringComparison.Ordinal);
        Assert.Equal(scenes.Select(name => $"{name} {Program.Hash(name, 4)}"), lines.Skip(1));
    }

    [Theory]
    [InlineData("independent", 5)]
    [InlineData("jittered", 9)]
    public void The_command_renders_the_bits_that_the_library_does(string sampler, int samples)
    {
        string scene = Path.Combine(_folder, "scene.json");
        string text = TestScenes.Everything.Replace("SAMPLER", sampler, StringComparison.Ordinal)
            .Replace("\"samplesPerPixel\": 16", $"\"samplesPerPixel\": {samples}", StringComparison.Ordinal);
        File.WriteAllText(scene, text);
        string expected = new RTracer(TestScenes.Build(text)).Render().Film.ComputeHash();
        foreach (string setting in TestSettings.Thorough ? new[] { "", "DOTNET_MaxVectorTBitWidth=128" } : [""])
        {
            string output = ChildProcess.Run("raytracer.dll", setting, "render", scene, "--json", "--quiet", "--threads", "2");
            Assert.Equal(expected, JsonDocument.Parse(output).RootElement.GetProperty("filmHash").GetString());
        }
    }
}
