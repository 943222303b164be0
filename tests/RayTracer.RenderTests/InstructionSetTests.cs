using System.Diagnostics;
using System.Text.Json;
using RayTracer.Tests.Rendering;

namespace RayTracer.RenderTests;

/// <summary>
/// The same picture, to the bit, whatever instructions and register widths the runtime may use: each case is a child process
/// with another setting of the runtime.
/// </summary>
public sealed class InstructionSetTests : IDisposable
{
    private static readonly string s_program = Path.Combine(AppContext.BaseDirectory, "raytracer.dll");
    private readonly string _folder = Directory.CreateTempSubdirectory("raytracer-").FullName;

    public static TheoryData<string, string> Samplers() => new()
    {
        { "sobol", "16" }, { "jittered", "9" }, { "independent", "5" }, { "regular", "4" },
    };

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Theory]
    [MemberData(nameof(Samplers))]
    public void Pictures_have_the_same_bits_with_every_instruction_set(string sampler, string samples)
    {
        string scene = Path.Combine(_folder, "scene.json");
        File.WriteAllText(scene, TestScenes.Everything.Replace("SAMPLER", sampler, StringComparison.Ordinal)
            .Replace("\"samplesPerPixel\": 16", $"\"samplesPerPixel\": {samples}", StringComparison.Ordinal));
        string expected = FilmHash(scene);
        Assert.Equal(64, expected.Length);
        Assert.All(
            [
                "DOTNET_MaxVectorTBitWidth=128",
                "DOTNET_MaxVectorTBitWidth=256",
                "DOTNET_MaxVectorTBitWidth=512",
                "DOTNET_EnableAVX512=0",
                "DOTNET_EnableAVX2=0",
                "DOTNET_TieredCompilation=1",
            ],
            setting => Assert.Equal(expected, FilmHash(scene, setting)));
    }

    [Fact]
    public void Pictures_have_the_same_bits_without_any_vector_instructions()
    {
        string scene = Path.Combine(_folder, "scene.json");
        File.WriteAllText(scene, TestScenes.Everything.Replace("SAMPLER", "sobol", StringComparison.Ordinal)
            .Replace("\"width\": 48, \"height\": 32, \"samplesPerPixel\": 16", "\"width\": 24, \"height\": 16, \"samplesPerPixel\": 2", StringComparison.Ordinal));
        Assert.Equal(FilmHash(scene), FilmHash(scene, "DOTNET_EnableHWIntrinsic=0"));
    }

    private static string FilmHash(string scene, string setting = "")
    {
        ProcessStartInfo start = new("dotnet", [s_program, "render", scene, "--json", "--quiet", "--threads", "2"])
        {
            UseShellExecute = false,
            RedirectStandardOutput = true,
        };
        start.Environment.Remove("DOTNET_MaxVectorTBitWidth");
        if (setting.Split('=') is [string name, string value])
        {
            start.Environment[name] = value;
        }

        using Process process = Process.Start(start)!;
        try
        {
            Task<string> output = process.StandardOutput.ReadToEndAsync();
            Assert.True(process.WaitForExit(TimeSpan.FromMinutes(2)), $"still running with {setting}");
            Assert.Equal(0, process.ExitCode);
            return JsonDocument.Parse(output.Result).RootElement.GetProperty("filmHash").GetString()!;
        }
        finally
        {
            process.Kill(entireProcessTree: true);
        }
    }
}
