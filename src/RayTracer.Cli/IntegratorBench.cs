using System.CommandLine;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary><c>raytracer bench SCENE --integrators LIST</c>: the options, and what is checked before hours of rendering.</summary>
internal sealed class IntegratorBench
{
    private const string All = "all";
    private const double StandardSeconds = 30;
    private const int ReferenceSamples = 16384;
    private const string ChartExtension = ".svg";

    // The most that scenes may ask for: the time decides.
    private const int MostSamples = 1 << 24;

    // So that a reference by the scene's own seed has no samples in common with what is measured.
    private const int OtherSeed = 0x5eed;

    private readonly ParsedOption<IReadOnlyList<Integrator>?> _integrators = new(
        "--integrators",
        string.Join(',', [All, .. Integrator.Known.Names]),
        $"Renders one scene with several integrators, each for the same time, and prints how their errors fall; the word {All} is for those that follow light to its end.",
        Parse);

    private readonly ParsedOption<double?> _seconds = OptionValues.Number(
        "--seconds", $"With --integrators: the time of each; {StandardSeconds} without it. Measuring errors does not count.", 0.01, 1e6);

    private readonly Option<string?> _reference = new("--reference")
    {
        Description = "With --integrators: the picture without noise, as a film or as an image in linear light, of the scene's size.",
        HelpName = "FILE",
    };

    private readonly Option<string?> _output = new("-o", "--output") { Description = $"With --integrators: draws the errors against time into this file ({ChartExtension}).", HelpName = "FILE" };

    /// <summary>Gives a command the options.</summary>
    public IntegratorBench(Command command) => command.AddOptions([_integrators, .. Own]);

    private Option[] Own => [_seconds, _reference, _output];

    /// <summary>Returns whether integrators are compared.</summary>
    /// <param name="result">The words that were given.</param>
    /// <param name="other">An option of measuring rays.</param>
    /// <exception cref="CommandException">There are options of both.</exception>
    public bool IsWanted(ParseResult result, Option other)
    {
        bool isWanted = _integrators.Value(result) is not null;
        Option[] unused = isWanted ? [other] : Own;
        return unused.FirstOrDefault(o => result.GetResult(o) is { Implicit: false }) is not { } stray ? isWanted
            : throw new CommandException(ExitStatus.Usage, $"{stray.Name} {(isWanted ? "does not go with" : "needs")} {_integrators.Name}");
    }

    /// <summary>Measures.</summary>
    /// <param name="result">The words that were given.</param>
    /// <param name="scenes">The scene files.</param>
    /// <param name="settings">Values to put in the place of the scene's.</param>
    /// <param name="isJson">True if a JSON object is printed.</param>
    /// <param name="stages">Takes the ends of stages.</param>
    /// <param name="streams">The streams to write to.</param>
    /// <returns>One of <see cref="ExitStatus"/>.</returns>
    public int Run(ParseResult result, string[] scenes, IReadOnlyList<SceneSetting> settings, bool isJson, StageTimes stages, Streams streams)
    {
        if (scenes is not [var path])
        {
            throw new CommandException(ExitStatus.Usage, $"{_integrators.Name} is for one scene, but there are {scenes.Length}");
        }

        RenderJob job = new() { Scene = SceneFile.Name(path), Text = path == SceneFile.Input ? Console.In.ReadToEnd() : null, Settings = settings };
        string file = result.GetValue(_reference) ?? throw new CommandException(
            ExitStatus.Usage, $"compared to what? Give --reference FILE; this makes one: {(job.WithSamples(ReferenceSamples) with { Outputs = ["reference.rtfilm"] }).Command}");
        SceneLoadResult whole = job.Load();
        streams.Read(whole.Diagnostics);
        if (whole.Scene is not { } scene)
        {
            return SceneFile.FailureStatus(path);
        }

        CheckSampler(scene.Render.Sampler);
        Picture reference = Reference(file, scene.Render);
        string? chart = result.GetValue(_output);
        CheckChart(chart);
        stages.End(JobStage.Load);
        using StopSignals signals = new(streams);
        ConvergenceRun run = new(job, file, TimeSpan.FromSeconds(_seconds.Value(result) ?? StandardSeconds), streams) { Table = isJson ? TextWriter.Null : streams.Output };
        run.Measure(_integrators.Value(result)!, reference, s => Endless(s, job), whole.Diagnostics, signals.Token);
        stages.End(JobStage.Render);
        run.Finish(chart, isJson);
        stages.End(JobStage.Write);
        return signals.Status != 0 ? signals.Status : run.Curves.Count == 0 ? ExitStatus.Scene : ExitStatus.Fine;
    }

    // Path first, whose errors the others are compared with.
    private static Integrator[] Parse(string word)
    {
        IEnumerable<Integrator> all = word.Equals(All, StringComparison.OrdinalIgnoreCase)
            ? Integrator.Known.All.Where(i => i.Has(IntegratorTraits.Light | IntegratorTraits.PathLimit)) : word.Split(',').Select(Named);
        return [.. all.Distinct().OrderBy(i => i != Integrator.Path)];
    }

    private static Integrator Named(string name) => Integrator.Known.Find(name) ?? throw new FormatException(
        $"unknown integrator {Quotation.Of(name)}{Spelling.DidYouMean(name, Integrator.Known.Names)}, expected {All}, or some of {string.Join(", ", Integrator.Known.Names)}");

    private static SceneDescription Endless(SceneDescription scene, RenderJob job) => scene with
    {
        Render = scene.Render with { SamplesPerPixel = job.GivenSamples ?? MostSamples, Seed = scene.Render.Seed ^ OtherSeed },
    };

    private void CheckSampler(SamplerKind sampler)
    {
        if (sampler.DependsOnCount)
        {
            throw new CommandException(
                ExitStatus.Usage,
                $"{_integrators.Name}: the pattern of the {sampler.ToString().ToLowerInvariant()} sampler needs the number of samples in advance: use --set render.sampler=sobol or independent");
        }
    }

    private static Picture Reference(string path, RenderDescription render)
    {
        if (ImageFile.FormatOf(path) is { } format && format.Features.HasFlag(ImageFeatures.Display))
        {
            throw new CommandException(
                ExitStatus.Usage, $"--reference {path}: {format.FileName} is for displays, which lose bright light: give a film or {ImageFormat.OfName(".exr")!.FileName}");
        }

        Picture reference = ImageFile.Read(path);
        return (reference.Width, reference.Height) == (render.Width, render.Height) ? reference : throw new CommandException(
            ExitStatus.Usage,
            $"--reference {path} has {reference.Width}×{reference.Height} pixels, but the scene {render.Width}×{render.Height}: "
                + $"give --set render.width={reference.Width} --set render.height={reference.Height}, or another reference");
    }

    private static void CheckChart(string? path)
    {
        if (path is not null && !path.EndsWith(ChartExtension, StringComparison.OrdinalIgnoreCase))
        {
            throw new CommandException(ExitStatus.Usage, $"-o {path}: the chart is an SVG drawing, whose name ends in {ChartExtension}");
        }

        if (path is not null)
        {
            JobFiles.CheckFolder(path);
        }
    }
}
