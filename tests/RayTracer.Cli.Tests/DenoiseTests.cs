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
