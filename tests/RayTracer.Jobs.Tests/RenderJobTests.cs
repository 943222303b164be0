using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Jobs.Tests;

public sealed class RenderJobTests
{
    [Fact]
    public void The_last_of_several_settings_counts()
    {
        RenderJob job = new RenderJob { Scene = "a.json" }.With(["render.samplesPerPixel=4", "crop=0,0,2,2", "render.samplesPerPixel=9"]);
        Assert.Equal((9, new Tile(0, 0, 2, 2)), (job.GivenSamples, job.Crop!.Value));
        Assert.Equal("raytracer render a.json --spp 4 --spp 9 --crop 0,0,2,2", job.Command);
    }

    [Fact]
    public void A_number_of_samples_replaces_what_decided_on_it()
    {
        RenderJob job = new RenderJob { Scene = "a.json", Noise = 0.01 }.With(["render.samplesPerPixel=4", "render.seed=3"]).WithSamples(7);
        Assert.Null(job.Noise);
        Assert.Equal(["render.seed=3", "render.samplesPerPixel=7"], job.FilmSettings);
    }

    [Fact]
    public void Films_keep_what_decides_on_their_samples_and_pictures_all_that_is_seen()
    {
        RenderJob job = new RenderJob { Scene = "a.json", Threads = 3, Outputs = ["b.png"] }.With(["frames=5", "noise=0.02", "exposure=1", "crop=0,0,2,2"]);
        Assert.Equal(["noise=0.02", "frames=5"], job.FilmSettings);
        Assert.Equal(["noise=0.02", "frames=5", "exposure=1", "crop=0,0,2,2"], job.PictureSettings);
        Assert.Equal("raytracer render a.json --exposure 1 --crop 0,0,2,2 --noise 0.02 --frames 5 -o b.png", job.Command);
        Assert.Equal(5, job.Frame);
    }

    [Fact]
    public void A_file_that_looks_like_an_option_is_named_from_its_folder() =>
        Assert.Equal("raytracer render ./-a.json -o ./-b.png", new RenderJob { Scene = "-a.json", Outputs = ["-b.png"] }.Command);

    [Fact]
    public void The_sample_that_was_not_finite_is_named_by_its_replay() => Assert.Equal(
        "raytracer render a.json --seed 3 --pixel 5,6 --sample 7",
        new RenderJob { Scene = "a.json", Outputs = ["b.png"] }.With(["render.seed=3", "exposure=2"]).ReplayCommand(new(5, 6, 7, default)));

    [Theory]
    [InlineData("a.png", false, false)]
    [InlineData("a.rtfilm", false, true)]
    [InlineData("a.exr", false, false)]
    [InlineData("a.exr", true, true)]
    public void A_job_knows_whether_its_film_goes_to_a_file(string output, bool exrFilm, bool keepsFilm) =>
        Assert.Equal(keepsFilm, new RenderJob { Scene = "a.json", Outputs = [output], Writing = new() { ExrFilm = exrFilm } }.KeepsFilm);
}
