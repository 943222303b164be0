using System.Text.Json;
using RayTracer.Cli;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Cli.Tests;

/// <summary>Renders that are stopped, films of which there is only a part, and how they are gone on with.</summary>
public sealed class UnfinishedFilmTests : IDisposable
{
    private const int Stopped = 130;
    private readonly TemporaryFolder _folder = new();
    private readonly string _scene;
    private readonly string _film;

    public UnfinishedFilmTests()
    {
        _scene = _folder["scene.json"];
        _film = _folder["film.rtfilm"];
        File.WriteAllText(_scene, CliRun.Scene);
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Stopped_between_passes_auxiliary_images_are_of_the_samples_that_there_are_and_the_picture_can_be_verified()
    {
        string[] outputs = ["-o", _folder["a.png"], "-o", _folder["a.exr"]];
        CliRun run = StopAtFirstCheckpoint(["render", _scene, "--spp", "1000", "--checkpoint", _film, "--checkpoint-interval", "0", "--aov", "depth", .. outputs]);
        Assert.Equal(Stopped, run.Status);
        Assert.True(File.ReadAllBytes(_folder["a.exr"]).AsSpan().IndexOf("depth.Z"u8) >= 0);
        Dictionary<string, string> texts = new(ImageFile.ReadText(_folder["a.png"]));
        Assert.Contains("unfinished", texts["Samples"], StringComparison.Ordinal);
        CliRun.Fine("verify", _folder["a.png"]);
        CliRun.Fine("render", _scene, "--spp", "1000", "--samples", texts["SampleRange"], "--aov", "depth", "-o", _folder["b.png"]);
        Assert.Equal(ImageFile.Read(_folder["b.depth.png"]).Pixels, ImageFile.Read(_folder["a.depth.png"]).Pixels);
    }

    [Fact]
    public void Stopped_before_those_of_a_film_that_is_resumed_are_made_auxiliary_images_are_left_out()
    {
        CliRun.Fine("render", _scene, "--spp", "4", "--checkpoint", _film);
        using CancellationTokenSource source = new();
        source.Cancel();
        using StringWriter error = new();
        CliRun run = Run(["render", _scene, "--spp", "8", "--checkpoint", _film, "--resume", "--aov", "depth", "-o", _folder["a.exr"]], source, error, () => { });
        Assert.Equal(Stopped, run.Status);
        Assert.Contains("the auxiliary images (--aov) were made: they are left out", run.Error, StringComparison.Ordinal);
        Assert.False(File.ReadAllBytes(_folder["a.exr"]).AsSpan().IndexOf("depth.Z"u8) >= 0);
    }

    [Fact]
    public void An_image_with_more_samples_in_some_places_is_not_verified()
    {
        string image = _folder["a.png"];
        KeyValuePair<string, string>[] texts = [new("FilmHash", "0"), new("Command", $"raytracer render {_scene} -o a.png"), new("Samples", "4, unfinished: 7 paths")];
        ImageFile.Write(image, new Picture(1, 1), new() { Metadata = texts });
        CliRun.Refused(4, $"'{image}' is unfinished", "verify", image);
    }

    [Fact]
    public void A_film_that_comes_to_where_checkpoints_go_is_kept_and_failures_do_not_count()
    {
        RenderJob job = new() { Scene = _scene, Checkpoint = _film };
        using StringWriter output = new();
        using StringWriter error = new();
        ConsoleRun console = new(new(Quiet: true, Json: true), new(output, error));
        JobRun run = new(job.WithCheckpoint(), console)
        {
            Change = s =>
            {
                WriteOther(_film);
                return s;
            },
        };
        int status = console.Run(job, run, () => 0, default).Status;
        Assert.Equal(4, status);
        Assert.Contains($"Cannot write '{_film}': another rendering has written its film there meanwhile", error.ToString(), StringComparison.Ordinal);
        Assert.Equal("other", FilmFile.ReadHeader(_film).Content);
        Assert.Equal(0, JsonDocument.Parse(output.ToString()).RootElement.GetProperty("checkpoints").GetInt32());
    }

    [Fact]
    public void Merging_does_not_write_over_films_that_it_does_not_hold()
    {
        string group = _folder["group.rtfilm"];
        CliRun.Fine("render", _scene, "--spp", "8", "--samples", "0..1", "-o", _film);
        CliRun.Fine("render", _scene, "--spp", "8", "--samples", "4..7", "-o", _folder["b.rtfilm"]);
        WriteOther(group);
        CliRun.Refused(4, $"'{group}' holds samples 0..0 of an unfinished rendering", "merge", "--partial", _film, "-o", group);
        File.Delete(group);
        CliRun.Fine("merge", "--partial", _film, "-o", group);
        CliRun.Fine("merge", "--partial", group, _folder["b.rtfilm"], "-o", _folder["both.rtfilm"]);
        File.Move(_folder["both.rtfilm"], group, overwrite: true);
        Assert.Equal("0..1, 4..7", FilmFile.ReadHeader(group).SamplesText);
        CliRun.Refused(4, $"'{group}' holds samples 0..1, 4..7 of an unfinished rendering: merge the missing samples in; delete it to begin from scratch", "merge", "--partial", _film, "-o", group);
        CliRun.Refused(4, "merge the missing samples in", "render", _scene, "-o", group);
    }

    [Fact]
    public void Frames_are_not_written_over_other_unfinished_films()
    {
        WriteOther(_folder["f-1.rtfilm"]);
        string[] command = ["render", _scene, "--frames", "0..1", "--spp", "2", "-o", _folder["f-#.rtfilm"]];
        CliRun.Refused(4, $"'{_folder["f-1.rtfilm"]}' holds samples 0..0 of an unfinished rendering", command);
        Assert.Equal("other", FilmFile.ReadHeader(_folder["f-1.rtfilm"]).Content);

        // The same frame with fewer samples.
        FilmHeader header = FilmFile.ReadHeader(_folder["f-0.rtfilm"]);
        FilmFile.Write(_folder["f-0.rtfilm"], new(header.Width, header.Height), header with { Samples = [new(0, 1)] });
        File.Delete(_folder["f-1.rtfilm"]);
        CliRun.Fine(command);
        Assert.True(FilmFile.ReadHeader(_folder["f-0.rtfilm"]).IsComplete);
    }

    [Fact]
    public void A_part_is_not_made_the_whole_picture()
    {
        CliRun.Fine("render", _scene, "--spp", "12", "--part", "1/3", "--checkpoint", _film, "--quiet");
        CliRun.Refused(2, "--spp 12: the film is a part of a picture, samples 0..3 of 12: render the others and merge", "resume", _film, "--spp", "12");
        Assert.Contains("has all samples of its part, 0..3", CliRun.Of("resume", _film).Error, StringComparison.Ordinal);
    }

    [Fact]
    public void A_film_of_some_time_is_given_more_time_and_stays_whole()
    {
        CliRun.Fine("render", _scene, "--time", "0.01", "-o", _film, "--quiet");
        int before = FilmFile.ReadHeader(_film).Total;
        CliRun.Fine("resume", _film, "--time", "0.01", "-o", _folder["a.png"], "--quiet");
        FilmHeader header = FilmFile.ReadHeader(_film);
        Assert.True(header.IsComplete);
        Assert.InRange(header.Total, before + 1, 65536);
        CliRun.Fine("verify", _folder["a.png"]);
        CliRun again = CliRun.Of("resume", _film, "--quiet");
        Assert.Equal(0, again.Status);
        Assert.Contains($"'{_film}' has all {header.Total} samples: give --spp or --time for more; nothing is rendered", again.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void The_same_command_goes_on_from_its_checkpoint()
    {
        string[] command = ["render", _scene, "--spp", "9", "--checkpoint", _film, "--resume", "--json", "--quiet"];
        CliRun.Refused(2, "--resume continues from a checkpoint: give --checkpoint FILE", "render", _scene, "--resume", "--json");
        string whole = Text(CliRun.Of("render", _scene, "--spp", "9", "--json", "--quiet"), "filmHash");
        Assert.Equal(whole, Text(CliRun.Of(command), "filmHash"));
        File.Delete(_film);
        CliRun.Fine("render", _scene, "--spp", "9", "--samples", "0..4", "-o", _film, "--quiet");
        (FilmHeader header, Film film) = FilmFile.Read(_film);
        FilmFile.Write(_film, film, header with { Wanted = new(0, 9) });
        CliRun run = CliRun.Of(command);
        Assert.Equal((0, "", whole, $"{4 * 24 * 16}"), (run.Status, run.Error, Text(run, "filmHash"), Text(run, "paths")));
        CliRun again = CliRun.Of(command);
        Assert.Equal((0, "", whole, "0"), (again.Status, again.Error, Text(again, "filmHash"), Text(again, "paths")));
        CliRun.Refused(4, $"'{_film}' holds samples 0..8, which are not the first of the requested 0..4", [.. command, "--samples", "0..4"]);
        CliRun.Refused(4, $"the film is not of '{_scene}'", [.. command, "--seed", "5"]);
    }

    [Fact]
    public async Task What_was_found_out_of_the_noise_is_gone_on_with_too()
    {
        string[] command = ["render", _scene, "--width", "480", "--height", "320", "--noise", "0.001%", "--checkpoint", _film, "--checkpoint-interval", "0", "--quiet"];
        using CancellationTokenSource source = new();
        Task<CliRun> deciding = Task.Run(() => Run(command, source, TextWriter.Null));
        Assert.True(SpinWait.SpinUntil(() => File.Exists(_film) || deciding.IsCompleted, 60_000));
        await source.CancelAsync();
        Assert.Equal(Stopped, (await deciding).Status);
        FilmHeader decision = FilmFile.ReadHeader(_film);
        Assert.Equal((120 * 80, 2), (decision.Width, decision.Height));
        CliRun.Refused(4, $"'{_film}' holds no samples of the picture yet", "merge", _film, "--json");
        CliRun.Refused(4, $"'{_film}' holds no samples of the picture yet", "verify", _film);
        CliRun.Refused(4, " of this picture: --resume continues it", command);
        CliRun.Refused(2, "--spp 9: it is being decided how many samples", "resume", _film, "--spp", "9");
        CliRun.Refused(4, $"the film is not of '{_scene}'", [.. command, "--resume", "--seed", "3"]);

        CliRun hasty = CliRun.Of("resume", _film, "--time", "0.001", "--json", "--quiet");
        Assert.Equal(5, hasty.Status);
        FilmHeader picture = FilmFile.ReadHeader(_film);
        Assert.Equal(480, picture.Width);
        Assert.True(picture.Samples[0].End < picture.Wanted.End);

        // Now it is decided: there is no more to decide about.
        CliRun last = CliRun.Of([.. command[..^1], "--resume", "--time", "0.001", "--json"]);
        Assert.Equal(5, last.Status);
        Assert.Contains($"time ran out before the wanted noise was reached: there are {picture.Samples[0].End + 1} of {picture.Wanted.End} samples", last.Error, StringComparison.Ordinal);
        Assert.Equal($"{480 * 320}", Text(last, "paths"));
    }

    private static CliRun Run(string[] words, CancellationTokenSource source, TextWriter error, Action? atLoad = null)
    {
        RenderJob job = OldFilms.OfWords(words[1..], "the command");
        ConsoleRun console = new(new(Quiet: true), new(TextWriter.Null, error));
        JobRun run = new(job.WithCheckpoint(), console)
        {
            Change = scene =>
            {
                atLoad?.Invoke();
                return scene;
            },
        };
        int status = console.Run(job, run, () => source.IsCancellationRequested ? Stopped : 0, source.Token).Status;
        return new(status, "", $"{error}");
    }

    // Its checkpoints cannot be written, and it is stopped when it says so.
    private CliRun StopAtFirstCheckpoint(string[] words)
    {
        using CancellationTokenSource source = new();
        using StoppingWriter error = new(source);
        return Run([.. words, "--quiet"], source, error, () => WriteOther(_film));
    }

    // An unfinished film of something else.
    private static void WriteOther(string path) => FilmFile.Write(path, new(4, 3), new FilmHeader { Width = 4, Height = 3, Content = "other", Samples = [new(0, 1)], Wanted = new(0, 8), Total = 8 });

    private static string Text(CliRun run, string key) => JsonDocument.Parse(run.Output).RootElement.GetProperty(key).ToString();

    /// <summary>Standard error that somebody watches, who presses Ctrl-C at the first line.</summary>
    private sealed class StoppingWriter(CancellationTokenSource source) : StringWriter
    {
        public override void WriteLine(string? value)
        {
            base.WriteLine(value);
            source.Cancel();
        }
    }
}
