using RayTracer.Imaging;

namespace RayTracer.Cli.Tests;

/// <summary>The options --define and --lenient.</summary>
public sealed class MitsubaOptionTests : IDisposable
{
    private const string Scene = """
        <scene version="3.0.0"><default name="light" value="1"/><sensor type="perspective"><transform name="to_world"><lookat origin="0,0,5" target="0,0,0" up="0,1,0"/></transform>
        <film type="hdrfilm"><integer name="width" value="16"/><integer name="height" value="16"/><rfilter type="box"/></film></sensor>
        <emitter type="constant"><rgb name="radiance" value="$light"/></emitter>THINGS</scene>
        """;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Parameters_of_a_scene_are_given_on_the_command_line()
    {
        File.WriteAllText(_folder["a.xml"], Scene.Replace("THINGS", "", StringComparison.Ordinal));
        CliRun.Fine("render", _folder["a.xml"], "--quiet", "-o", _folder["a.pfm"], "-D", "light=0.25");
        Assert.All(ImageFile.Read(_folder["a.pfm"]).Pixels, p => Assert.Equal(0.25f, p));
        Assert.Contains("stands nowhere", CliRun.Of("check", _folder["a.xml"], "--define", "lihgt=2").Output, StringComparison.Ordinal);
        CliRun wrong = CliRun.Of("check", _folder["a.xml"], "-D", "light");
        Assert.Equal((2, true), (wrong.Status, wrong.Error.Contains("must be a name and a value", StringComparison.Ordinal)));
    }

    [Fact]
    public void What_is_not_supported_is_rendered_with_a_stand_in_that_is_seen()
    {
        File.WriteAllText(_folder["a.xml"], Scene.Replace("THINGS", """<shape type="sphere"><bsdf type="hair"/></shape>""", StringComparison.Ordinal));
        string[] command = ["render", _folder["a.xml"], "--quiet", "-o", _folder["a.pfm"]];
        Assert.Equal(3, CliRun.Of(command).Status);
        CliRun run = CliRun.Of([.. command, "--lenient"]);
        Assert.Equal(0, run.Status);
        Assert.Contains("magenta is shown instead", run.Error, StringComparison.Ordinal);
        Assert.Contains(ImageFile.Read(_folder["a.pfm"]).Pixels.Chunk(3), p => p[0] > 0.9f && p[1] == 0 && p[2] > 0.9f);
    }
}
