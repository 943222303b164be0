using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Jobs.Tests;

/// <summary><see cref="JobRun"/>, as a program calls it.</summary>
public sealed class JobRunTests : IDisposable
{
    private const string Scene = """
        {
          "camera": { "position": [0, 1, 5], "lookAt": [0, 0.5, 0] },
          "render": { "integrator": "report", "width": 12, "height": 8, "samplesPerPixel": 4 },
          "background": "skyblue",
          "shapes": [{ "type": "sphere", "center": [0, 0.5, 0], "radius": 0.5 }],
          "lights": [{ "type": "sphere", "center": [2, 4, 1], "radius": 0.3, "material": { "type": "luminaire", "multiplier": 30 } }]
        }
        """;

    private readonly TemporaryFolder _folder = new();
    private readonly Watch _watch = new();
    private readonly RenderJob _job;

    public JobRunTests()
    {
        File.WriteAllText(_folder["scene.json"], Scene);
        _job = new() { Scene = _folder["scene.json"], Threads = 2 };
    }

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("", "a.png")]
    [InlineData("time=3600s,render.samplesPerPixel=4", "a.png")]
    [InlineData("aov=depth", "a.png,a.depth.png")]
    [InlineData("aov=emission", "a.png,a.emission.png")]
    [InlineData("time=3600s,render.samplesPerPixel=4,aov=emission", "a.png,a.emission.png")]
    [InlineData("denoise=true", "a.png,a.denoised.png")]
    public void The_bits_are_those_of_the_renderer_however_it_is_rendered(string settings, string files)
    {
        RenderJob job = _job.With(settings.Split(',', StringSplitOptions.RemoveEmptyEntries));
        JobResult result = new JobRun(job with { Outputs = [_folder["a.png"]] }, _watch).Run(CancellationToken.None)!;
        Assert.Equal(Hash(), result.Hash);
        Assert.True(result.IsWritten, string.Join('\n', _watch.Lines));
        Assert.Equal(files.Split(',').Select(f => _folder[f]), result.Files);
        Dictionary<string, string> texts = new(ImageFile.ReadText(_folder["a.png"]));
        Assert.Equal((result.Hash, "4"), (texts["FilmHash"], texts["Samples"].Split(' ')[0]));
    }

    [Fact]
    public void Stages_end_in_their_order()
    {
        new JobRun(_job with { Outputs = [_folder["a.pfm"]] }, _watch).Run(CancellationToken.None);
        Assert.Equal([JobStage.Load, JobStage.Build, JobStage.Render, JobStage.Write], _watch.Stages);
    }

    [Theory]
    [InlineData("")]
    [InlineData("adaptive=true")]
    [InlineData("time=3600s")]
    [InlineData("samples=1..13")]
    [InlineData("noise=0.5")]
    public void A_denoised_picture_stands_beside_the_same_film(string settings)
    {
        RenderJob job = _job.WithSamples(16).With(settings.Split(',', StringSplitOptions.RemoveEmptyEntries)) with { Outputs = [_folder["a.png"]] };
        string plain = new JobRun(job, _watch).Run(CancellationToken.None)!.Hash;
        JobResult result = new JobRun(job with { Denoise = true }, _watch).Run(CancellationToken.None)!;
        Assert.Equal((plain, true), (result.Hash, result.IsWritten));
        Assert.Equal([JobStage.Render, JobStage.Denoise, JobStage.Write], _watch.Stages.TakeLast(3));
        Assert.NotEqual(result.Film.ToPicture().Pixels, result.Denoised!.Picture.Pixels);
    }

    [Fact]
    public void What_was_rendered_until_a_stop_is_denoised()
    {
        RenderJob job = _job.WithSamples(4_000_000) with { Outputs = [_folder["a.png"]], Denoise = true };
        using CancellationTokenSource stop = new();
        int reports = 0;
        _watch.Progress = () => _ = ++reports == 12 ? stop.CancelAsync() : Task.CompletedTask;
        JobResult result = new JobRun(job, _watch).Run(stop.Token)!;
        Assert.Equal((true, true), (result.Statistics.Cancelled, result.IsWritten));
        Assert.True(File.Exists(_folder["a.denoised.png"]));
    }

    [Fact]
    public void Without_a_second_half_there_is_no_denoised_picture_and_a_warning()
    {
        RenderJob job = _job with { Outputs = [_folder["a.png"]], Denoise = true, Part = (1, 4) };
        Assert.Null(new JobRun(job, _watch).Run(CancellationToken.None)!.Denoised);
        Assert.Contains("two halves", Assert.Single(_watch.Lines), StringComparison.Ordinal);
    }

    [Fact]
    public void Parts_merge_to_the_bits_of_the_whole()
    {
        string[] files = [_folder["1.rtfilm"], _folder["2.rtfilm"], _folder["3.rtfilm"]];
        for (int i = 0; i < 3; i++)
        {
            Assert.True(new JobRun(_job with { Outputs = [files[i]], Part = (i + 1, 3) }, _watch).Run(CancellationToken.None)!.IsWritten);
        }

        FilmMerge merge = FilmMerge.Of(files);
        Assert.Null(merge.Missing);
        Assert.Equal(Hash(), merge.Add().ComputeHash());
        Assert.Equal("samples 1..1 are missing of 4", FilmMerge.Of([files[0], files[2]]).Missing);
        JobException twice = Assert.Throws<JobException>(() => FilmMerge.Of([files[0], files[0]]));
        Assert.Contains("are in both", twice.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Parts_with_halves_merge_to_the_whole_and_without_one_there_are_none()
    {
        RenderJob job = _job.WithSamples(13) with { Halves = true };
        string[] files = [.. Enumerable.Range(1, 4).Select(i => _folder[$"{i}.rtfilm"])];
        for (int i = 0; i < 4; i++)
        {
            new JobRun(job with { Outputs = [files[i]], Part = (i + 1, 4) }, _watch).Run(CancellationToken.None);
        }

        JobResult whole = new JobRun(job with { Outputs = [_folder["whole.rtfilm"]] }, _watch).Run(CancellationToken.None)!;
        FilmMerge merge = FilmMerge.Of([files[2], files[0], files[3], files[1]]);
        Assert.Equal((whole.Hash, 0), (merge.Add().ComputeHash(), merge.Lost.Count));
        Assert.NotEqual(whole.Hash, whole.Film.ComputeHash([]));

        new JobRun(job with { Halves = false, Outputs = [files[1]], Part = (2, 4) }, _watch).Run(CancellationToken.None);
        merge = FilmMerge.Of(files);
        Assert.Equal((files[1], FilmPlane.Half), Assert.Single(merge.Lost));
        Assert.Equal(whole.Film.ComputeHash([]), merge.Add().ComputeHash());
    }

    [Fact]
    public void A_resumed_film_is_denoised_as_if_it_had_not_been_stopped()
    {
        RenderJob job = _job.WithSamples(12) with { Outputs = [_folder["a.pfm"]], Denoise = true };
        new JobRun(job, _watch).Run(CancellationToken.None);
        byte[] denoised = File.ReadAllBytes(_folder["a.denoised.pfm"]);
        string film = _folder["a.rtfilm"];
        JobResult few = new JobRun(_job.WithSamples(5) with { Outputs = [film], Halves = true }, _watch).Run(CancellationToken.None)!;
        Assert.Equal([FilmPlane.Half], few.Header!.Planes);
        JobResult more = new JobRun(job with { Resumed = HeldFilm.Read(film), Outputs = [_folder["b.pfm"], film] }, _watch).Run(CancellationToken.None)!;
        Assert.Equal(denoised, File.ReadAllBytes(_folder["b.denoised.pfm"]));
        Assert.Equal(more.Hash, FilmFile.Read(film).Film.ComputeHash());
        Assert.Contains("\"halves=true\"", new Dictionary<string, string>(PictureTexts.Of(more.Header!, more.Hash))[PictureTexts.SettingsKey], StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("denoise=true")]
    [InlineData("halves=true")]
    public void A_film_without_halves_is_not_given_any_later(string setting)
    {
        string film = _folder["a.rtfilm"];
        new JobRun(_job.WithSamples(5) with { Outputs = [film] }, _watch).Run(CancellationToken.None);
        RenderJob more = _job.WithSamples(12).With([setting]) with { Outputs = [_folder["a.png"]], Resumed = HeldFilm.Read(film) };
        JobException fault = Assert.Throws<JobException>(() => new JobRun(more, _watch).Run(CancellationToken.None));
        Assert.StartsWith($"'{film}' does not keep two halves of its samples", fault.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_film_is_resumed_and_one_of_another_scene_is_refused()
    {
        string film = _folder["a.rtfilm"];
        new JobRun(_job.WithSamples(2) with { Outputs = [film] }, _watch).Run(CancellationToken.None);
        RenderJob more = _job.WithSamples(4) with { Outputs = [film], Resumed = HeldFilm.Read(film) };
        Assert.Equal(Hash(), new JobRun(more, _watch).Run(CancellationToken.None)!.Hash);
        File.WriteAllText(_job.Scene, Scene.Replace("skyblue", "black", StringComparison.Ordinal));
        JobException other = Assert.Throws<JobException>(() => new JobRun(more with { Resumed = HeldFilm.Read(film) }, _watch).Run(CancellationToken.None));
        Assert.StartsWith("the film is not of", other.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("", "a.png")]
    [InlineData("adaptive=true", "a.png")]
    [InlineData("denoise=true", "a.png,a.denoised.png")]
    [InlineData("denoise=true;adaptive=true", "a.png,a.denoised.png")]
    [InlineData("denoise=true;aov=emission", "a.png,a.denoised.png,a.emission.png")]
    [InlineData("aov=depth", "a.png,a.depth.png")]
    [InlineData("aov=direct", "a.png,a.direct.png")]
    [InlineData("part=2/3", "a.png")]
    [InlineData("samples=3..50000", "a.png")]
    [InlineData("crop=2,1,5,4", "a.png")]
    [InlineData("noise=0.000001", "a.png")]
    public void A_stopped_picture_has_the_samples_of_its_whole_passes(string settings, string files)
    {
        RenderJob job = _job.WithSamples(60_000).With(settings.Split(';', StringSplitOptions.RemoveEmptyEntries)) with { Outputs = [_folder["a.png"]], Threads = 2 };
        using CancellationTokenSource stop = new();
        _watch.Reported = p =>
        {
            if (p.SamplesDone >= 3)
            {
                stop.Cancel();
            }
        };
        JobResult result = new JobRun(job, _watch).Run(stop.Token)!;
        Assert.Equal((true, true), (result.Statistics.Cancelled, result.IsWritten));
        Assert.Equal(files.Split(',').Select(f => _folder[f]).Order(), result.Files.Order());
        int samples = result.Statistics.SamplesPerPixel;
        Assert.InRange(samples, 3, 50_000);
        Tile area = job.Crop ?? new(0, 0, result.Film.Width, result.Film.Height);
        Assert.All(Enumerable.Range(0, area.Pixels), i => Assert.Equal((uint)samples, result.Film.SampleCount(area.Pixel(i).X, area.Pixel(i).Y)));
        Film film = new(result.Film.Width, result.Film.Height);
        int first = job.Samples?.First ?? (job.Part is null ? 0 : 20_000);
        new RTracer(result.Scene, new() { Samples = new(first, first + samples), Crop = job.Crop }).Render(film);
        Assert.Equal(film.ComputeHash(), result.Hash);
        if (job.Aovs.Count > 0)
        {
            AovFilm seen = new(film, job.Aovs);
            new FirstHitPass(result.Scene, new() { Samples = new(0, samples) }).Render(seen);
            double[][] rows = [.. new[] { seen, result.Auxiliary! }.Select(a => Row(a, job.Aovs[0]))];
            Assert.Equal(rows[0], rows[1]);
        }
    }

    [Theory]
    [InlineData("")]
    [InlineData("denoise=true")]
    [InlineData("adaptive=true")]
    [InlineData("aov=direct")]
    public void Between_passes_the_film_is_shown_with_as_many_samples_of_each_pixel(string settings)
    {
        RenderJob job = _job.WithSamples(40).With(settings.Split(';', StringSplitOptions.RemoveEmptyEntries)) with { Outputs = [_folder["a.png"]] };
        List<(uint[] Counts, bool IsLast)> shown = [];
        _watch.Offered = (film, isLast) =>
            shown.Add(([.. Enumerable.Range(0, film.Width * film.Height).Select(i => film.SampleCount(i % film.Width, i / film.Width))], isLast));
        JobResult result = new JobRun(job, _watch).Run(CancellationToken.None)!;
        Assert.Equal(shown.Count - 1, shown.FindIndex(s => s.IsLast));
        Assert.All(shown, s => Assert.True(s.Counts.Distinct().Count() == 1 || result.Plan is not null));
        uint[] most = [.. shown.Select(s => s.Counts.Max())];
        Assert.Equal(1u, most[0]);
        Assert.Equal(most.Distinct().Order(), most);
    }

    [Fact]
    public void Nothing_is_written_of_a_picture_that_is_stopped_in_its_first_pass()
    {
        RenderJob job = _job with { Outputs = [_folder["a.png"]], Checkpoint = _folder["a.rtfilm"] };
        JobResult result = new JobRun(job, _watch).Run(new(canceled: true))!;
        Assert.Equal((true, false, 0L), (result.Statistics.Cancelled, result.IsWritten, result.Film.TotalSamples));
        Assert.Empty(result.Files);
        Assert.False(File.Exists(_folder["a.rtfilm"]));
    }

    [Fact]
    public void A_stopped_picture_that_is_one_of_several_is_not_written()
    {
        RenderJob job = _job.WithSamples(4_000_000) with { Outputs = [_folder["a.png"]], IsOfSequence = true };
        using CancellationTokenSource stop = new();
        int reports = 0;
        _watch.Progress = () => _ = ++reports == 12 ? stop.CancelAsync() : Task.CompletedTask;
        JobResult result = new JobRun(job, _watch).Run(stop.Token)!;
        Assert.Equal((true, false, false), (result.Statistics.Cancelled, result.IsWritten, File.Exists(_folder["a.png"])));
    }

    [Theory]
    [InlineData("crop=8,0,8,8", "--crop 8,0,8,8: is not within the picture of 12×8 pixels")]
    [InlineData("part=1/5", "--part 1/5: 4 samples make at most 4 parts")]
    [InlineData("samples=2..9", "--samples 2..9: the pixels have only samples 0 to 3")]
    [InlineData("render.sampler=jittered\nnoise=0.1", "--noise: the pattern of the jittered sampler needs the number of samples in advance")]
    [InlineData("denoise=true\nrender.samplesPerPixel=1", "--denoise compares two halves of the samples")]
    public void What_the_scene_does_not_have_is_refused_before_the_work(string settings, string message)
    {
        RenderJob job = _job.With(settings.Split('\n')) with { Outputs = [_folder["a.png"]] };
        JobException fault = Assert.Throws<JobException>(() => new JobRun(job, _watch).Run(CancellationToken.None));
        Assert.StartsWith(message, fault.Message, StringComparison.Ordinal);
        Assert.Equal(JobFault.Request, fault.Fault);
        Assert.False(File.Exists(_folder["a.png"]));
    }

    [Fact]
    public void Two_images_for_one_file_are_refused()
    {
        JobException fault = Assert.Throws<JobException>(() => new PictureFiles(_job with { Outputs = ["a.png", "a.depth.png"], Aovs = [AuxiliaryImage.Known.Find("depth")!] }));
        Assert.Equal("--aov depth writes to 'a.depth.png' beside 'a.png', but another image goes there", fault.Message);
    }

    [Fact]
    public void A_wrong_scene_is_reported_and_has_no_result()
    {
        File.WriteAllText(_job.Scene, "{ \"shapes\": 3 }");
        Assert.Null(new JobRun(_job with { Outputs = [_folder["a.png"]] }, _watch).Run(CancellationToken.None));
        Assert.NotEmpty(_watch.Lines);
    }

    private static double[] Row(AovFilm images, AuxiliaryImage image)
    {
        double[] values = new double[images.Width * image.Letters.Length];
        images.ReadRow(image, images.Height / 2, values);
        return values;
    }

    private string Hash() => new RTracer(SceneLoader.Load(_job.Scene).Scene!).Render().Film.ComputeHash();

    private sealed class Watch : IJobWatch, IProgress<RenderProgress>
    {
        public List<string> Lines { get; } = [];

        public List<JobStage> Stages { get; } = [];

        public Action? Progress { get; set; }

        public Action<RenderProgress>? Reported { get; set; }

        public Action<Film, bool>? Offered { get; set; }

        public bool ShowsPasses => Offered is not null;

        public void Warn(string message) => Lines.Add(message);

        public void Fail(string message) => Lines.Add(message);

        public void Read(IReadOnlyList<Diagnostic> diagnostics) => Lines.AddRange(diagnostics.Select(d => d.Message));

        public void End(JobStage stage) => Stages.Add(stage);

        public IProgress<RenderProgress> Begin(RenderDescription render) => this;

        public void Offer(Film film, bool isLast) => Offered?.Invoke(film, isLast);

        public void Report(RenderProgress value)
        {
            Progress?.Invoke();
            Reported?.Invoke(value);
        }
    }
}
