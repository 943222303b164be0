using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Jobs.Tests;

/// <summary><see cref="RenderJob.Guide"/> in jobs: films, parts, resumed renderings and files of what was learned.</summary>
public sealed class GuidanceTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly Watch _watch = new();
    private readonly RenderJob _job;

    public GuidanceTests()
    {
        File.WriteAllText(_folder["scene.json"], GuidedScenes.Screen.Replace("24, \"height\": 16", "12, \"height\": 8", StringComparison.Ordinal));
        _job = new() { Scene = _folder["scene.json"], Threads = 2, Guide = true };
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Guided_parts_merge_to_the_whole_whether_they_learn_or_read_what_was_learned()
    {
        JobResult whole = Run(_job with { Outputs = [_folder["whole.rtfilm"]] });
        Scene scene = SceneLoader.Load(_job.Scene).Scene!;
        Assert.Equal(new RTracer(GuidedScenes.Learned(scene)).Render().Film.ComputeHash(), whole.Hash);
        Assert.Equal(12 * 8 * 16, whole.Film.TotalSamples);
        string[] files = [_folder["3.rtfilm"], _folder["1.rtfilm"], _folder["2.rtfilm"]];
        RenderJob kept = _job with { GuideFile = _folder["a.guide"] };
        Assert.True(Run(_job with { Outputs = [files[0]], Part = (3, 3) }).Guide!.Paths > 0);
        Assert.True(Run(kept with { Outputs = [files[1]], Part = (1, 3) }).Guide!.Paths > 0);
        Assert.Equal(0, Run(kept with { Outputs = [files[2]], Part = (2, 3) }).Guide!.Paths);
        Assert.Equal(whole.Hash, FilmMerge.Of(files).Add().ComputeHash());

        Run(_job with { Guide = false, Outputs = [_folder["plain.rtfilm"]], Part = (2, 3) });
        Assert.Contains("--guide", Assert.Throws<JobException>(() => FilmMerge.Of([files[0], _folder["plain.rtfilm"]])).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_guided_film_is_resumed_to_the_bits_of_the_whole_and_only_as_guided()
    {
        string file = _folder["a.rtfilm"];
        Run(_job with { Outputs = [file], Samples = new(0, 5) });
        HeldFilm held = HeldFilm.Read(file);
        Assert.Contains("guide=true", held.Header.Settings);
        RenderJob rest = _job with { Resumed = held, Samples = new(0, 16), Outputs = [_folder["b.rtfilm"]] };
        Assert.Equal(Run(_job).Hash, Run(rest).Hash);
        held = HeldFilm.Read(file);
        Assert.Contains("rendered with --guide", Assert.Throws<JobException>(() => Run(rest with { Resumed = held, Guide = false })).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_guide_of_another_scene_or_a_damaged_one_is_refused()
    {
        RenderJob job = _job with { GuideFile = _folder["a.guide"] };
        string hash = Run(job).Hash;
        Assert.Contains("another scene", Refused(job.With(["render.seed=7"])), StringComparison.Ordinal);
        Assert.Equal(hash, Run(job.With(["render.samplesPerPixel=16"])).Hash);
        byte[] bytes = File.ReadAllBytes(_folder["a.guide"]);
        bytes[^9] ^= 1;
        File.WriteAllBytes(_folder["a.guide"], bytes);
        Assert.Contains("damaged", Refused(job), StringComparison.Ordinal);
        File.WriteAllBytes(_folder["a.guide"], bytes[..100]);
        Assert.Contains("damaged", Refused(job), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("report")]
    [InlineData("volPath")]
    [InlineData("direct")]
    public void Other_integrators_are_refused(string integrator) =>
        Assert.Equal(
            $"--guide: only the path integrator learns where light comes from, and the scene is rendered by {integrator}: give --integrator path, or leave --guide out",
            Refused(_job.With([$"render.integrator={integrator}"])));

    [Theory]
    [InlineData("denoise=true")]
    [InlineData("aov=emission")]
    [InlineData("time=3600s,render.samplesPerPixel=16")]
    public void It_goes_with_what_changes_no_samples(string settings)
    {
        JobResult result = Run(_job.With(settings.Split(',')) with { Outputs = [_folder["a.png"]] });
        Assert.Equal((Run(_job).Hash, true), (result.Hash, result.IsWritten));
    }

    [Fact]
    public void Adaptive_pictures_are_guided()
    {
        RenderJob job = _job with { Adaptive = true };
        Assert.NotEqual(Run(job with { Guide = false }).Hash, Run(job).Hash);
        Assert.NotNull(Run(job).Plan);
    }

    private JobResult Run(RenderJob job)
    {
        JobResult result = new JobRun(job, _watch).Run(CancellationToken.None)!;
        Assert.NotNull(result);
        return result;
    }

    private string Refused(RenderJob job) => Assert.Throws<JobException>(() => Run(job)).Message;

    private sealed class Watch : IJobWatch
    {
        public void Warn(string message)
        {
        }

        public void Fail(string message) => Assert.Fail(message);

        public void Read(IReadOnlyList<Diagnostic> diagnostics) => Assert.Empty(diagnostics);
    }
}
