using RayTracer.Imaging;
using RayTracer.Textures;

namespace RayTracer.Cli.Tests;

/// <summary><c>raytracer denoise</c>.</summary>
public sealed class DenoiseTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public DenoiseTests()
    {
        File.WriteAllText(_folder["scene.json"], """
            { "render": { "width": 64, "height": 48, "integrator": "path" }, "camera": { "position": [0, 1.5, 5], "lookAt": [0, 0.6, 0] }, "shapes": [
              { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": { "type": "checker", "even": "white", "odd": "steelblue" } } },
              { "type": "sphere", "center": [0, 0.6, 0], "radius": 0.6, "material": { "type": "diffuse", "color": "tomato" } },
              { "type": "sphere", "center": [2, 4, 2], "radius": 1, "material": { "type": "luminaire", "multiplier": 12 } }] }
            """);
        Render("noisy.exr", 8, "--aov", "albedo,normal", "-o", _folder["noisy.pfm"], "-o", _folder["noisy.png"]);
        Render("reference.pfm", 1024, "--seed", "2");
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Layers_guide_it_as_files_do_and_halves_of_samples_are_better()
    {
        Denoise("noisy.exr", "layers.pfm");
        Denoise("noisy.pfm", "files.pfm", "--albedo", _folder["noisy.albedo.pfm"], "--normal", _folder["noisy.normal.pfm"]);
        Denoise("noisy.pfm", "pictures.pfm", "--albedo", _folder["noisy.albedo.png"], "--normal", _folder["noisy.normal.png"], "--threads", "1");
        Render("halves.pfm", 8, "--denoise");
        double noisy = Error("noisy.pfm");
        Assert.InRange(Error("layers.pfm") / noisy, 0, 0.9);
        Assert.InRange(Error("files.pfm") / Error("layers.pfm"), 0.98, 1.02);
        Assert.InRange(Error("pictures.pfm") / Error("layers.pfm"), 0.9, 1.1);
        Assert.InRange(Error("halves.denoised.pfm") / Error("layers.pfm"), 0, 1);
    }

    [Fact]
    public void The_last_line_says_where_the_denoised_picture_is()
    {
        (string png, string exr) = (_folder["a.png"], _folder["a.exr"]);
        CliRun run = CliRun.Of("render", _folder["scene.json"], "--spp", "2", "--denoise", "-o", png, "-o", exr);
        Assert.EndsWith(
            $"the denoised picture is {_folder["a.denoised.png"]} ({png} keeps its noise) and the layer \"denoised\" of {exr}",
            run.Output.TrimEnd(),
            StringComparison.Ordinal);
    }

    [Fact]
    public void Without_guides_there_is_a_warning()
    {
        CliRun run = CliRun.Of("denoise", _folder["noisy.pfm"], "-o", _folder["alone.png"]);
        Assert.Equal(0, run.Status);
        Assert.Contains("nothing is known of the surfaces", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void A_guide_of_another_size_and_an_output_that_is_read_are_refused()
    {
        ImageFile.Write(_folder["small.pfm"], new Picture(4, 3));
        CliRun other = CliRun.Of("denoise", _folder["noisy.pfm"], "--albedo", _folder["small.pfm"], "-o", _folder["x.png"]);
        Assert.Equal(2, other.Status);
        Assert.Contains("has 4×3 pixels, but", other.Error, StringComparison.Ordinal);
        CliRun lost = CliRun.Of("denoise", _folder["noisy.exr"], "-o", _folder["noisy.exr"]);
        Assert.Equal(4, lost.Status);
        Assert.Contains("would be lost", lost.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void A_film_with_halves_is_denoised_as_the_rendering_is_wherever_it_comes_from()
    {
        Render("whole.pfm", 8, "--denoise", "-o", _folder["whole.rtfilm"]);
        Denoise("whole.rtfilm", "a.pfm", "--threads", "1");
        Assert.Equal(File.ReadAllBytes(_folder["whole.denoised.pfm"]), File.ReadAllBytes(_folder["a.pfm"]));

        Render("1.rtfilm", 8, "--halves", "--part", "1/2");
        Render("2.exr", 8, "--halves", "--part", "2/2", "--exr-film");
        CliRun.Fine("merge", _folder["1.rtfilm"], _folder["2.exr"], "-o", _folder["merged.exr"], "--exr-film");
        Denoise("merged.exr", "b.pfm");
        Assert.Equal(File.ReadAllBytes(_folder["a.pfm"]), File.ReadAllBytes(_folder["b.pfm"]));
        Assert.Contains("planes     half\n", CliRun.Fine("info", _folder["merged.exr"]).Output, StringComparison.Ordinal);

        Render("few.rtfilm", 4, "--halves");
        CliRun.Fine("resume", _folder["few.rtfilm"], "--spp", "8", "--denoise", "-o", _folder["c.pfm"], "--quiet");
        Assert.Equal(File.ReadAllBytes(_folder["a.pfm"]), File.ReadAllBytes(_folder["c.denoised.pfm"]));
        CliRun.Fine("verify", _folder["few.rtfilm"]);
    }

    [Fact]
    public void A_film_without_halves_is_denoised_worse_with_a_warning()
    {
        Render("plain.rtfilm", 8);
        CliRun run = CliRun.Of("denoise", _folder["plain.rtfilm"], "-o", _folder["plain.pfm"]);
        Assert.Equal(0, run.Status);
        Assert.Contains("does not keep two halves of its samples (render --halves), so that its noise is estimated from its pixels alone, which is worse", run.Error, StringComparison.Ordinal);
        Render("halves.pfm", 8, "--denoise");
        Assert.InRange(Error("plain.pfm") / Error("noisy.pfm"), 0, 0.9);
        Assert.InRange(Error("halves.denoised.pfm") / Error("plain.pfm"), 0, 1);
    }

    [Fact]
    public void A_film_that_cannot_be_denoised_is_refused_with_the_reason()
    {
        Render("a.rtfilm", 8, "--halves");
        Render("one.rtfilm", 8, "--halves", "--samples", "0..0");
        CliRun.Refused(4, "are of one of the two halves that are compared", "denoise", _folder["one.rtfilm"], "-o", _folder["x.png"]);
        CliRun.Refused(2, "--albedo and --normal are for images", "denoise", _folder["a.rtfilm"], "--albedo", _folder["noisy.albedo.pfm"], "-o", _folder["x.png"]);
        CliRun.Refused(2, "--scene is for films", "denoise", _folder["noisy.pfm"], "--scene", _folder["scene.json"], "-o", _folder["x.png"]);
        File.Move(_folder["scene.json"], _folder["moved.json"]);
        Denoise("a.rtfilm", "a.pfm", "--scene", _folder["moved.json"]);
        File.WriteAllText(_folder["moved.json"], File.ReadAllText(_folder["moved.json"]).Replace("tomato", "black", StringComparison.Ordinal));
        CliRun.Refused(4, "the film is not of", "denoise", _folder["a.rtfilm"], "--scene", _folder["moved.json"], "-o", _folder["x.png"]);
        CliRun.Refused(4, "does not keep two halves of its samples, which --denoise compares", "resume", Plain(), "--spp", "16", "--denoise", "-o", _folder["x.png"]);
        CliRun.Refused(2, "--denoise writes an image: where to?", "resume", _folder["a.rtfilm"], "--scene", _folder["moved.json"], "--denoise");
    }

    private string Plain()
    {
        File.WriteAllText(_folder["plain.json"], File.ReadAllText(_folder["moved.json"]));
        CliRun.Fine("render", _folder["plain.json"], "--spp", "4", "-o", _folder["plain.rtfilm"]);
        return _folder["plain.rtfilm"];
    }

    private void Render(string file, int samples, params string[] options)
    {
        CliRun run = CliRun.Of(["render", _folder["scene.json"], "--spp", $"{samples}", "-o", _folder[file], "--quiet", .. options]);
        Assert.Equal((0, ""), (run.Status, run.Error));
    }

    private void Denoise(string file, string output, params string[] options)
    {
        CliRun run = CliRun.Of(["denoise", _folder[file], "-o", _folder[output], .. options]);
        Assert.Equal((0, ""), (run.Status, run.Error));
    }

    private double Error(string file) => ImageComparison.Compare(ImageFile.Read(_folder[file]), ImageFile.Read(_folder["reference.pfm"])).RelativeMse;
}
