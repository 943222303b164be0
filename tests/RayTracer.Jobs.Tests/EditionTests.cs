using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Jobs.Tests;

/// <summary><see cref="RenderJob.Edition"/>: films of the textbook edition are its own.</summary>
public sealed class EditionTests : IDisposable
{
    private const string Scene = """
        { "render": { "width": 12, "height": 8, "samplesPerPixel": 4, "sampler": "independent", "integrator": "report" },
          "shapes": [ { "type": "sphere", "center": [0, 0, 0] } ],
          "lights": [ { "type": "sphere", "center": [2, 3, 2], "material": { "type": "luminaire", "multiplier": 5 } } ] }
        """;

    private readonly TemporaryFolder _folder = new();
    private readonly Watch _watch = new();
    private readonly RenderJob _job;

    public EditionTests()
    {
        File.WriteAllText(_folder["scene.json"], Scene);
        _job = new() { Scene = _folder["scene.json"], Threads = 2, Edition = "textbook" };
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Parts_of_the_textbook_edition_merge_to_its_whole_and_with_no_others()
    {
        JobResult whole = Run(_job with { Outputs = [_folder["whole.rtfilm"]] });
        Assert.Equal(12 * 8 * 4, whole.Film.TotalSamples);
        string[] files = [_folder["1.rtfilm"], _folder["2.rtfilm"]];
        Run(_job with { Outputs = [files[0]], Samples = new(0, 1) });
        Run(_job with { Outputs = [files[1]], Samples = new(1, 4), Threads = 1 });
        Assert.Equal(whole.Hash, FilmMerge.Of(files).Add().ComputeHash());
        Assert.Contains("depend on the system", HeldFilm.Read(files[0]).Header.Software, StringComparison.Ordinal);

        Run(_job with { Edition = null, Outputs = [_folder["fast.rtfilm"]], Samples = new(1, 4) });
        Assert.Contains("edition", Assert.Throws<JobException>(() => FilmMerge.Of([files[0], _folder["fast.rtfilm"]])).Message, StringComparison.Ordinal);
        Run(_job with { Edition = "textbook:whitted", Outputs = [_folder["whitted.rtfilm"]], Samples = new(1, 4) });
        Assert.Throws<JobException>(() => FilmMerge.Of([files[0], _folder["whitted.rtfilm"]]));
    }

    [Fact]
    public void A_film_is_resumed_by_its_own_edition_only()
    {
        string file = _folder["a.rtfilm"];
        Run(_job with { Outputs = [file], Samples = new(0, 1) });
        RenderJob rest = _job with { Resumed = HeldFilm.Read(file), Samples = new(0, 4), Outputs = [_folder["b.rtfilm"]] };
        Assert.Contains("edition=textbook", rest.Resumed!.Header.Settings);
        Assert.Equal(Run(_job).Hash, Run(rest).Hash);
        rest = rest with { Resumed = HeldFilm.Read(file), Edition = null };
        Assert.Contains("--edition textbook", Assert.Throws<JobException>(() => Run(rest)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_crop_holds_the_samples_of_its_pixels_alone()
    {
        JobResult whole = Run(_job);
        JobResult part = Run(_job with { Crop = new(3, 2, 5, 4) });
        for (int y = 0; y < 8; y++)
        {
            for (int x = 0; x < 12; x++)
            {
                bool isInside = x is >= 3 and < 8 && y is >= 2 and < 6;
                Assert.Equal(isInside ? 4u : 0u, part.Film.SampleCount(x, y));
                Assert.Equal(isInside ? whole.Film.Mean(x, y) : default, part.Film.Mean(x, y));
            }
        }
    }

    [Fact]
    public void What_the_edition_lacks_is_reported_and_nothing_is_rendered()
    {
        Assert.Null(new JobRun(_job.With(["render.integrator=vcm"]), _watch).Run(default));
        Assert.Contains(_watch.Diagnostics, d => d.Message.Contains("no integrator \"vcm\"", StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("denoise=true")]
    [InlineData("noise=5%")]
    [InlineData("aov=depth")]
    public void Other_works_are_the_fast_edition_s_alone(string setting)
    {
        RenderJob job = (_job with { Outputs = [_folder["a.exr"]] }).With([setting]);
        Assert.Contains("textbook edition", JobRules.Complaint(job), StringComparison.Ordinal);
    }

    private JobResult Run(RenderJob job) => new JobRun(job, _watch).Run(default)!;

    private sealed class Watch : IJobWatch
    {
        public List<Diagnostic> Diagnostics { get; } = [];

        public void Warn(string message) => Assert.Fail(message);

        public void Fail(string message) => Assert.Fail(message);

        public void Read(IReadOnlyList<Diagnostic> diagnostics) => Diagnostics.AddRange(diagnostics);
    }
}
