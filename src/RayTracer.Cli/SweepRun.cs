using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary>Renders the pictures of a sweep, and places them on a sheet.</summary>
/// <param name="job">The job, of which all pictures have the same values but for the axes.</param>
/// <param name="axes">The settings that change, and their values.</param>
/// <param name="change">Gives a scene the size of a cell.</param>
/// <param name="display">The user's choice of what is reported.</param>
/// <param name="streams">The streams to write to.</param>
internal sealed class SweepRun(
    RenderJob job, SweepAxes axes, Func<SceneDescription, SceneDescription> change, Display display, Streams streams)
{
    private readonly List<(SweepCell Cell, string Hash)> _films = [];
    private Exposure? _exposure;

    /// <summary>The sheet; null where nothing was rendered.</summary>
    public ContactSheet? Sheet { get; private set; }

    /// <summary>The hashes of the films.</summary>
    public IReadOnlyList<(SweepCell Cell, string Hash)> Films => _films;

    /// <summary>Finds out before hours of rendering whether there is a scene for each value, of the size of the others.</summary>
    /// <returns>True if there is; otherwise, what is wrong was reported.</returns>
    /// <exception cref="CommandException">The sizes differ.</exception>
    public bool Check()
    {
        (int Width, int Height)? size = null;
        foreach (SweepCell cell in axes.Samples)
        {
            SceneLoadResult loaded = Job(cell).Load(change);
            streams.Read(loaded.Diagnostics, display.Quiet || cell != axes.Samples.First());
            if (loaded.Scene is not { Render: var render })
            {
                return false;
            }

            size ??= (render.Width, render.Height);
            if (size != (render.Width, render.Height))
            {
                throw new CommandException(ExitStatus.Usage, OtherSize(size.Value, (render.Width, render.Height)));
            }
        }

        return true;
    }

    /// <summary>Renders all pictures.</summary>
    /// <returns>One of <see cref="ExitStatus"/>; the place of what fails stays dark.</returns>
    public int Render(CancellationToken cancellation)
    {
        int failed = ExitStatus.Fine;
        foreach (SweepCell cell in axes.Cells.TakeWhile(_ => !cancellation.IsCancellationRequested))
        {
            int status = Render(cell, cancellation);
            failed = status == ExitStatus.Fine ? failed : status;
        }

        return failed;
    }

    private RenderJob Job(SweepCell cell) => (job with { Settings = axes.Settings(cell) }).Sized();

    private int Render(SweepCell cell, CancellationToken cancellation)
    {
        string changes = string.Join(' ', axes.Changes(cell).Select(s => s.Text));
        ConsoleRun watch = new(new(Quiet: true, Verbose: display.Verbose), streams);
        if (new JobRun(Job(cell), watch) { Change = change }.Compute(cancellation) is not { } outcome)
        {
            streams.Fail($"these errors are with {changes}");
            return SceneFile.FailureStatus(job.Scene);
        }

        Sheet ??= SheetFor(outcome.Film);
        if ((outcome.Film.Width, outcome.Film.Height) != (Sheet.CellWidth, Sheet.CellHeight))
        {
            streams.Fail(OtherSize((Sheet.CellWidth, Sheet.CellHeight), (outcome.Film.Width, outcome.Film.Height)));
            return ExitStatus.Usage;
        }

        // As it is to be seen, whatever the file: labels have no exposure.
        Sheet.Place(Looks(outcome).Shown(outcome.Film), cell.Column, cell.Row, cell.Block);
        _films.Add((cell, outcome.Hash));
        outcome.WarnOfClamped(streams);
        if (!display.Quiet)
        {
            streams.Error.WriteLine($"{_films.Count} of {axes.Cells.Count()}: {changes}, {outcome.Seconds:F2} s");
        }

        return ExitStatus.Fine;
    }

    // With one exposure, where pictures decide on theirs: that of the first one, so that the others compare with it.
    private ImageWriteOptions Looks(JobResult outcome)
    {
        ImageWriteOptions looks = job.Writing.For(outcome.Scene.Render);
        return looks.Exposure is { Rule: not ExposureRule.Stops } ? looks with { Exposure = _exposure ??= looks.Exposed(outcome.Film).Exposure } : looks;
    }

    private static string OtherSize((int Width, int Height) size, (int Width, int Height) other) =>
        $"pictures of {size.Width}×{size.Height} and of {other.Width}×{other.Height} pixels do not fit one grid: give --width and --height";

    private ContactSheet SheetFor(Film film)
    {
        try
        {
            return new(axes.Columns, axes.Rows, axes.Blocks, film.Width, film.Height);
        }
        catch (ArgumentException e)
        {
            throw new CommandException(ExitStatus.Usage, $"{e.Message}: give a smaller --cell, or fewer values");
        }
    }
}
