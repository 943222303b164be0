using System.CommandLine;
using System.Diagnostics;
using System.Runtime.InteropServices;
using System.Text.Json;
using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary>
/// <c>raytracer bench --against FOLDER</c>: renders scenes with another build of the command and with this one, in turn, and compares processor
/// time and noise. Machines differ and are shared, so that only ratios of one run tell anything.
/// </summary>
internal sealed partial class BenchAgainst
{
    private const int StandardRounds = 15;
    private const double LargestLoss = 1.1;
    private const double Tail = 0.025;

    // As in relMSE, so that black pixels do not decide.
    private const double Floor = 0.01;

    // The share of pixels that is left out, those of largest error: single fireflies would decide.
    private const double LeftOut = 0.005;

    private readonly Option<string?> _folder = new("--against")
    {
        Description = "Renders with the raytracer of this folder and with this one, in turn, each round with another seed, and prints ratios of processor time and noise.",
        HelpName = "FOLDER",
    };

    private readonly ParsedOption<long?> _rounds = OptionValues.Integer("--rounds", $"With --against: how often each renders; {StandardRounds} without it.", 2, 1000);

    /// <summary>Gives a command the options.</summary>
    public BenchAgainst(Command command) => command.AddOptions(_folder, _rounds);

    /// <summary>Returns whether builds are compared.</summary>
    public bool IsWanted(ParseResult result) => result.GetValue(_folder) is not null || (_rounds.Value(result) is null ? false
        : throw new CommandException(ExitStatus.Usage, $"{_rounds.Name} needs {_folder.Name}"));

    /// <summary>Measures.</summary>
    /// <param name="result">The words that were given.</param>
    /// <param name="scenes">The scene files.</param>
    /// <param name="settings">Values to put in the place of the scenes'.</param>
    /// <param name="isJson">True if a JSON object is printed.</param>
    /// <param name="streams">The streams to write to.</param>
    /// <returns>One of <see cref="ExitStatus"/>; <see cref="ExitStatus.Different"/> where this build needs a tenth more time to the same noise.</returns>
    public int Run(ParseResult result, IReadOnlyList<string> scenes, IReadOnlyList<SceneSetting> settings, bool isJson, Streams streams)
    {
        string other = Program(result.GetValue(_folder)!);
        if (!File.Exists(other))
        {
            throw new CommandException(ExitStatus.Usage, $"--against: there is no command in this folder ({other})");
        }

        int rounds = (int)(_rounds.Value(result) ?? StandardRounds);
        List<Comparison> all = [];
        foreach (string path in scenes)
        {
            SceneLoadResult loaded = SceneFile.Load(path, new(null), settings: settings);
            streams.Read(loaded.Diagnostics);
            if (loaded.Description is not { Render: var render })
            {
                return SceneFile.FailureStatus(path);
            }

            // What may have another default in another build is said.
            string[] words =
            [
                path, "--integrator", render.Integrator.Name, "--sampler", $"{render.Sampler}".ToLowerInvariant(), "--max-depth", $"{render.MaxDepth}", "--json",
                .. settings.SelectMany(s => new[] { "--set", $"{s.Path}={s.Value}" }),
            ];
            Comparison one = Compare(path, words, [new(other), new(Program(AppContext.BaseDirectory))], rounds, LanesOption.Given(result));
            all.Add(one);
            if (!isJson)
            {
                streams.Output.WriteLine($"{path,-40} time {one.Time:F3} [{one.Low:F3}, {one.High:F3}]  noise {one.Noise:F3}  time to equal noise {one.TimeToNoise:F3}{(one.HasSameBits ? "  (same bits)" : "")}");
            }
        }

        if (isJson)
        {
            JsonText.Write(streams, new() { ["rounds"] = rounds, ["scenes"] = JsonText.List(all.Select(Json)) });
        }

        Comparison[] losses = [.. all.Where(c => c.IsLoss)];
        foreach (Comparison slow in losses)
        {
            streams.Fail($"{slow.Path}: this build takes {slow.TimeToNoise:F2} of the time to the same noise");
        }

        return losses.Length > 0 ? ExitStatus.Different : ExitStatus.Fine;
    }

    /// <summary>Returns the ranks, from 0, between which the median of a distribution lies with a probability of 95 %.</summary>
    /// <param name="count">The number of values.</param>
    internal static (int Low, int High) RanksAroundMedian(int count)
    {
        // Binomial: the chance that fewer than k of the values are below the median.
        double chance = double.Pow(0.5, count);
        double below = 0;
        int rank = 0;
        while (below + chance <= Tail)
        {
            below += chance;
            chance *= (double)(count - rank) / (rank + 1);
            rank++;
        }

        rank = Math.Max(rank - 1, 0);
        return (rank, count - 1 - rank);
    }

    private static Comparison Compare(string path, string[] words, Build[] builds, int rounds, string? lanes)
    {
        string file = Path.Combine(Path.GetTempPath(), $"raytracer-bench-{Guid.NewGuid():N}.pfm");
        try
        {
            for (int round = 0; round < rounds; round++)
            {
                // Each is the first one as often as the other.
                foreach (Build build in round % 2 == 0 ? builds : builds.Reverse())
                {
                    build.Render([.. words, "--seed", $"{round + 1}", "-o", file], file, lanes);
                }
            }
        }
        finally
        {
            File.Delete(file);
        }

        double[] ratios = [.. builds[1].Times.Zip(builds[0].Times, (own, other) => own / other).Order()];
        (int low, int high) = RanksAroundMedian(rounds);
        double median = rounds % 2 == 1 ? ratios[rounds / 2] : (ratios[(rounds / 2) - 1] + ratios[rounds / 2]) / 2;
        bool hasSameBits = builds[0].Hashes.SequenceEqual(builds[1].Hashes);
        return new(path, median, ratios[low], ratios[high], hasSameBits ? 1 : Noise(builds[1], builds) / Noise(builds[0], builds), hasSameBits);
    }

    // The mean over pixels of the variance of a render, relative to what all renders are on average.
    private static double Noise(Build build, Build[] all)
    {
        int rounds = build.Times.Count;
        double[] errors = new double[build.Sums!.Length / 3];
        for (int i = 0; i < build.Sums.Length; i++)
        {
            double mean = all.Sum(b => b.Sums![i]) / (rounds * all.Length);
            double variance = (build.Squares![i] - (build.Sums[i] * build.Sums[i] / rounds)) / (rounds - 1);
            errors[i / 3] += variance / ((mean * mean) + Floor);
        }

        Array.Sort(errors);
        return errors.Take((int)(errors.Length * (1 - LeftOut))).Average();
    }

    private static JsonObject Json(Comparison one) => new()
    {
        ["path"] = one.Path,
        ["time"] = one.Time,
        ["timeLow"] = one.Low,
        ["timeHigh"] = one.High,
        ["noise"] = one.Noise,
        ["timeToNoise"] = one.TimeToNoise,
        ["hasSameBits"] = one.HasSameBits,
    };

    private static string Program(string folder) => Path.Combine(folder, OperatingSystem.IsWindows() ? "raytracer.exe" : "raytracer");

    // Ratios of this build to the other.
    private sealed record Comparison(string Path, double Time, double Low, double High, double Noise, bool HasSameBits)
    {
        public double TimeToNoise => Time * Noise;

        // A tenth, of which chance is not the reason.
        public bool IsLoss => TimeToNoise > LargestLoss && Low * Noise > 1;
    }

    private sealed partial class Build(string program)
    {
        private const int Children = -1;

        public List<double> Times { get; } = [];

        public List<string> Hashes { get; } = [];

        public double[]? Sums { get; private set; }

        public double[]? Squares { get; private set; }

        public void Render(string[] words, string file, string? lanes)
        {
            ProcessStartInfo start = new(program, ["render", .. words]) { UseShellExecute = false, RedirectStandardOutput = true, RedirectStandardError = true };

            // This program may have been started again with registers that the user did not ask for.
            start.Environment.Remove(WideVectors.Variable);
            start.Environment.Remove(WideVectors.Preference);
            start.Environment.Remove(WideVectors.Tiers);
            if (lanes is not null)
            {
                start.Environment[WideVectors.Variable] = start.Environment[WideVectors.Preference] = $"{32 * int.Parse(lanes)}";
            }

            double before = OfChildren();
            using Process process = Process.Start(start)!;
            Task<string> errors = process.StandardError.ReadToEndAsync();
            string output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            if (process.ExitCode != ExitStatus.Fine)
            {
                throw new CommandException(ExitStatus.InputOutput, $"{program}: {Shell.Command(["render", .. words])} ended with status {process.ExitCode}: {errors.Result.Split('\n')[0]}");
            }

            Times.Add(OperatingSystem.IsWindows() ? process.TotalProcessorTime.TotalSeconds : OfChildren() - before);
            using JsonDocument report = JsonDocument.Parse(output);
            Hashes.Add(report.RootElement.GetProperty("filmHash").GetString()!);
            Add(ImageFile.Read(file).Pixels);
        }

        private void Add(float[] pixels)
        {
            Sums ??= new double[pixels.Length];
            Squares ??= new double[pixels.Length];
            for (int i = 0; i < pixels.Length; i++)
            {
                Sums[i] += pixels[i];
                Squares[i] += (double)pixels[i] * pixels[i];
            }
        }

        private static double OfChildren()
        {
            if (OperatingSystem.IsWindows())
            {
                return 0;
            }

            _ = ResourceUsage(Children, out Usage usage);
            return usage.UserSeconds + usage.SystemSeconds + (1e-6 * (usage.UserMicroseconds + usage.SystemMicroseconds));
        }

        [LibraryImport("libc", EntryPoint = "getrusage")]
        [DefaultDllImportSearchPaths(DllImportSearchPath.SafeDirectories)]
        private static partial int ResourceUsage(int who, out Usage usage);

        // rusage of getrusage(2): times of the children that have ended, before fourteen numbers that are not used.
        [StructLayout(LayoutKind.Sequential, Size = 144)]
        private struct Usage
        {
            public long UserSeconds;
            public long UserMicroseconds;
            public long SystemSeconds;
            public long SystemMicroseconds;
        }
    }
}
