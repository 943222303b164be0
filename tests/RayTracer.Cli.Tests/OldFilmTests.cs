using System.Globalization;
namespace RayTracer.Cli.Tests;

/// <summary>Films and images of the first format, which hold words of a command line (<see cref="Jobs.OldFilms"/>).</summary>
public sealed class OldFilmTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public OldFilmTests()
    {
        foreach (string file in Directory.EnumerateFiles(ProjectFolder.PathOf("tests", "RayTracer.Cli.Tests", "Old")))
        {
            File.Copy(file, _folder[Path.GetFileName(file)]);
        }
    }

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("part-1.rtfilm")]
    [InlineData("part-2.rtfilm")]
    public void They_are_verified(string file) => CliRun.Fine("verify", _folder[file]);

    [Theory]
    [InlineData("frame.rtfilm", "samples that share camera rays")]
    [InlineData("carries.exr", "samples that share camera rays")]
    [InlineData("picture.png", "lights that camera paths sample")]
    public void Those_whose_bits_are_others_now_are_not_and_the_reason_is_given(string file, string kind)
    {
        string reason = $"was rendered before a fault was mended: the bits of scenes with {kind} are others now";
        CliRun.Refused(4, reason, "verify", _folder[file]);
        if (!file.EndsWith(".png", StringComparison.Ordinal))
        {
            CliRun.Refused(4, reason, "resume", _folder[file], "--spp", "7");
        }
    }

    [Fact]
    public void Their_files_are_of_version_2() => Assert.Equal(2, File.ReadAllBytes(_folder["part-1.rtfilm"])[8]);

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Parts_merge_with_each_other_and_with_new_ones(bool isNew)
    {
        if (isNew)
        {
            CliRun.Fine([.. Part, "--part", "2/2", "-o", _folder["new.rtfilm"]]);
        }

        string second = _folder[isNew ? "new.rtfilm" : "part-2.rtfilm"];
        Assert.Equal(CliRun.FilmHash([.. Part, "--json"]), CliRun.FilmHash("merge", _folder["part-1.rtfilm"], second, "--json", "-o", _folder["all.rtfilm"]));
        Assert.Equal(CliRun.FilmHash([.. Part.Select(w => w == "6" ? "8" : w), "--json"]), CliRun.FilmHash("resume", _folder["all.rtfilm"], "--spp", "8", "--json"));
    }

    [Fact]
    public void A_film_of_another_scene_is_refused()
    {
        File.WriteAllText(_folder["scene.json"], File.ReadAllText(_folder["scene.json"]).Replace("skyblue", "black", StringComparison.Ordinal));
        CliRun.Refused(4, "the film is not of", "resume", _folder["frame.rtfilm"], "--spp", "7");
    }

    [Fact]
    public void A_film_of_a_scene_that_named_no_integrator_keeps_the_one_of_the_report()
    {
        CliRun.Fine([.. Part, "-o", _folder["new.rtfilm"]]);
        File.WriteAllText(_folder["scene.json"], File.ReadAllText(_folder["scene.json"]).Replace("\"integrator\": \"report\", ", "", StringComparison.Ordinal));
        string reason = $"the film was rendered by the report integrator, but '{_folder["scene.json"]}' is rendered by path: write \"integrator\": \"report\" under \"render\"";
        CliRun.Refused(4, reason, "resume", _folder["new.rtfilm"], "--spp", "7");
    }

    [Fact]
    public void What_has_other_bits_now_is_refused_with_the_reason()
    {
        string reason = "was rendered before a fault was mended: the bits of scenes with meshes with literal shading normals or materials that transmit or ";
        CliRun.Refused(4, reason, "resume", _folder["literal.rtfilm"], "--spp", "8");
        CliRun.Refused(4, $"'{_folder["literal.rtfilm"]}' {reason}", "verify", _folder["literal.rtfilm"]);
    }

    private string[] Part =>
        ["render", _folder["scene.json"], "--spp", "6", "--sampler", "independent", "--set", "materials.paint.color=[0.9, 0.2, 0.1]", "--crop", "1,1,6,4"];
}
