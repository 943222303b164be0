using System.CommandLine;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary><c>raytracer verify FILE</c>: renders what an image or film says it is once more, and compares the films' hashes.</summary>
internal static class VerifyVerb
{
    public static void Build(Command command, Streams streams)
    {
        Argument<string> file = new("FILE")
        {
            Description = $"The film (.rtfilm), or the image ({ImageFormat.Endings(ImageFeatures.Texts)}) that this program wrote.",
        };
        Option<string?> scene = new("--scene") { Description = "The scene file, if it has moved.", HelpName = "SCENE" };
        ParsedOption<long?> threads = OptionValues.Integer("--threads", "Number of threads. Default: one per core.", 1, 1024);
        Option<bool> json = new("--json") { Description = "Prints one JSON object." };
        command.Arguments.Add(file);
        command.AddOptions(scene, threads, json);

        VerboseOption verbose = new(command);

        command.SetAction(result =>
        {
            StageTimes stages = verbose.Times(result, streams);
            Claim claim = Of(result.GetValue(file)!, result.GetValue(scene));
            stages.End("file");
            int status = Verify(
                claim, (int)(threads.Value(result) ?? Environment.ProcessorCount), verbose.Value(result), result.GetValue(json), streams);
            stages.EndAll();
            return status;
        });
    }

    private static int Verify(Claim claim, int threads, bool verbose, bool json, Streams streams)
    {
        using StopSignals signals = new(streams);
        Film? whole = null;
        foreach (SampleRange? range in claim.Samples)
        {
            RenderJob job = claim.Job with { Outputs = [], Aovs = [], Layers = [], Strategies = false, Denoise = false, Checkpoint = null, Threads = threads };

            // Whatever decided on the number of samples: these they are.
            job = range is null ? job : job with { Samples = range, Part = null, Noise = null, Time = null };
            JobResult? result = new JobRun(job, new ConsoleRun(new(Quiet: true, Verbose: verbose), streams)) { Change = s => Changed(s, claim, range) }.Compute(signals.Token);
            if (result is null)
            {
                return SceneFile.FailureStatus(job.Scene);
            }

            if (result.Statistics.Cancelled)
            {
                return signals.Status;
            }

            whole ??= new(result.Film.Width, result.Film.Height, result.Film.Planes);
            whole.Merge(result.Film);
        }

        string hash = whole?.ComputeHash() ?? "";
        bool same = hash == claim.Hash;
        if (json)
        {
            JsonText.Write(streams, new() { ["same"] = same, ["filmHash"] = claim.Hash, ["renderedHash"] = hash });
        }
        else
        {
            streams.Output.WriteLine(same ? $"the same to the bit: film {hash}" : $"another picture: the file's film is {claim.Hash}, but '{claim.Job.Scene}' rendered again is {hash}");
        }

        return same ? ExitStatus.Fine : ExitStatus.Different;
    }

    // Samples of a sampler without a pattern do not depend on how many there are.
    private static SceneDescription Changed(SceneDescription scene, Claim claim, SampleRange? range)
    {
        if (claim.IsOld)
        {
            OldFilms.CheckBits(scene, $"'{claim.File}'");
        }

        return range is { } samples && samples.End > scene.Render.SamplesPerPixel && !scene.Render.Sampler.DependsOnCount
            ? scene with { Render = scene.Render with { SamplesPerPixel = samples.End } }
            : scene;
    }

    private static Claim Of(string file, string? scene)
    {
        if (CarriedFilm.Is(file))
        {
            (FilmHeader header, Film film) = CarriedFilm.Read(file);
            HeldFilm.CheckPicture(header, file);
            return new(
                file, At(JobOrigin.Of(header, file).WithSamples(header.Total)), [.. header.Samples.Select(r => (SampleRange?)r)], film.ComputeHash(), IsOld: header.Words is not null);
        }

        (RenderJob job, IReadOnlyDictionary<string, string> texts) = JobOrigin.OfImage(file);
        if (!texts.TryGetValue("FilmHash", out string? hash))
        {
            throw JobOrigin.Unknown(file);
        }

        if (texts.ContainsKey("Aov") || texts.ContainsKey("Layer") || texts.ContainsKey("Denoised"))
        {
            throw new CommandException(ExitStatus.InputOutput, $"'{file}' is an image beside the picture: only the picture itself can be rendered again and compared");
        }

        if (texts.GetValueOrDefault("Samples")?.Contains("unfinished", StringComparison.Ordinal) == true
            && !texts.ContainsKey("SampleRange"))
        {
            throw new CommandException(ExitStatus.InputOutput, $"'{file}' is unfinished: it was stopped when some pixels had more samples than others, so that it cannot be rendered again");
        }

        SampleRange?[] ranges = texts.TryGetValue("SampleRange", out string? samples)
            ? [.. samples.Split(", ").Select(r => (SampleRange?)OptionWords.Samples(r))] : [null];
        return new(file, At(job), ranges, hash, IsOld: !texts.ContainsKey(PictureTexts.SettingsKey));

        RenderJob At(RenderJob job) => scene is null ? job : job with { Scene = scene };
    }

    /// <summary>The claim of a file about its making.</summary>
    /// <param name="File">The file.</param>
    /// <param name="Job">The job that rendered it.</param>
    /// <param name="Samples">The samples that it holds; null for those that the job decides on.</param>
    /// <param name="Hash">The hash of its film.</param>
    /// <param name="IsOld">True if it is of the first format.</param>
    private sealed record Claim(string File, RenderJob Job, IReadOnlyList<SampleRange?> Samples, string Hash, bool IsOld);
}
