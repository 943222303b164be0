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
        foreach (Option option in new Option[] { scene, threads.Symbol, json })
        {
            command.Options.Add(option);
        }

        VerboseOption verbose = new(command);

        command.SetAction(result =>
        {
            StageTimes stages = verbose.Times(result, streams);
            Claim claim = Of(result.GetValue(file)!, result.GetValue(scene));
            stages.End("file");
            int status = Verify(claim, (int)(threads.Value(result) ?? Environment.ProcessorCount), verbose.Value(result), result.GetValue(json), streams);
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
            RenderRequest request = claim.Request with { Outputs = [], Aovs = [], Denoise = false, Checkpoint = null, Threads = threads, Quiet = true, Verbose = verbose, Preview = false };
            if (range is not null)
            {
                // Whatever decided on the number of samples: these they are.
                request = request with { Samples = range, Part = null, Noise = null, Time = null };
            }

            RenderOutcome? outcome = new RenderRun(request, s => Widen(claim.Overrides(s), range), streams).Compute(signals.Token);
            if (outcome is null)
            {
                return SceneFile.FailureStatus(request.ScenePath);
            }

            if (outcome.Statistics.Cancelled)
            {
                return signals.Status;
            }

            whole ??= new(outcome.Film.Width, outcome.Film.Height);
            whole.Merge(outcome.Film);
        }

        string hash = whole?.ComputeHash() ?? "";
        bool same = hash == claim.Hash;
        if (json)
        {
            JsonText.Write(streams, writer =>
            {
                writer.WriteBoolean("same", same);
                writer.WriteString("filmHash", claim.Hash);
                writer.WriteString("renderedHash", hash);
            });
        }
        else
        {
            streams.Output.WriteLine(same ? $"the same to the bit: film {hash}" : $"a different picture: the file's film is {claim.Hash}, but rendering '{claim.Request.ScenePath}' again gives {hash}");
        }

        return same ? ExitStatus.Fine : ExitStatus.Different;
    }

    // Samples of a sampler without a pattern do not depend on how many there are.
    private static SceneDescription Widen(SceneDescription scene, SampleRange? range) =>
        range is { } samples && samples.End > scene.Render.SamplesPerPixel && !scene.Render.Sampler.DependsOnCount
            ? scene with { Render = scene.Render with { SamplesPerPixel = samples.End } }
            : scene;

    private static Claim Of(string file, string? scene)
    {
        if (CarriedFilm.Is(file))
        {
            (FilmHeader header, Film film) = CarriedFilm.Read(file);
            if (header.Samples.Count == 0)
            {
                throw new CommandException(ExitStatus.InputOutput, $"'{file}' holds no samples yet");
            }

            if (DecisionCheckpoint.Is(header))
            {
                throw DecisionCheckpoint.NoPicture(file);
            }

            (RenderRequest asked, Func<SceneDescription, SceneDescription> changes) =
                RenderVerb.Parse([scene ?? PictureOrigin.ScenePath(header.Scene, file), "--json", .. FilmTexts.Words(header, header.Total), .. FilmTexts.CropWords(header)]);
            return new(asked, changes, [.. header.Samples.Select(r => (SampleRange?)r)], film.ComputeHash());
        }

        Dictionary<string, string> texts = ImageFile.ReadText(file).GroupBy(t => t.Key).ToDictionary(g => g.Key, g => g.First().Value, StringComparer.Ordinal);
        if (!texts.TryGetValue("FilmHash", out string? hash) || !texts.TryGetValue("Command", out string? line) || Shell.Words(line) is not [_, "render", .. var words])
        {
            string those = $"only .rtfilm, {ImageFormat.Endings(ImageFeatures.Texts)} files of render, resume and merge do";
            throw new CommandException(ExitStatus.InputOutput, $"'{file}' does not say how it was made: {those}");
        }

        if (texts.ContainsKey("Aov") || texts.ContainsKey("Layer") || texts.ContainsKey("Denoised"))
        {
            throw new CommandException(ExitStatus.InputOutput, $"'{file}' is an image beside the picture: only the picture itself can be rendered again and compared");
        }

        if (texts.GetValueOrDefault("Samples")?.Contains("unfinished", StringComparison.Ordinal) == true && !texts.ContainsKey("SampleRange"))
        {
            throw new CommandException(ExitStatus.InputOutput, $"'{file}' is unfinished: it was stopped when some pixels had more samples than others, so it cannot be rendered again");
        }

        (RenderRequest request, Func<SceneDescription, SceneDescription> overrides) = RenderVerb.Parse(["--json", .. words]);
        SampleRange?[] ranges = texts.TryGetValue("SampleRange", out string? samples) ? [.. samples.Split(", ").Select(SampleShares.Range)] : [null];
        return new(request with { ScenePath = scene ?? PictureOrigin.ScenePath(request.ScenePath, file, request.Outputs) }, overrides, ranges, hash);
    }

    /// <summary>What a file says of itself.</summary>
    /// <param name="Request">How it was rendered.</param>
    /// <param name="Overrides">Puts the options of the command line into the scene.</param>
    /// <param name="Samples">The samples that it holds; null for those that the request decides on.</param>
    /// <param name="Hash">The hash of its film.</param>
    private sealed record Claim(RenderRequest Request, Func<SceneDescription, SceneDescription> Overrides, IReadOnlyList<SampleRange?> Samples, string Hash);
}
