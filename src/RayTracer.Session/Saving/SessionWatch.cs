using RayTracer.Description;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>Watches jobs in the background: reports how far several pictures are together, and keeps what goes wrong.</summary>
/// <param name="whole">Takes the progress.</param>
/// <param name="count">The number of pictures.</param>
/// <param name="cancellation">Ends the work.</param>
internal sealed class SessionWatch(IProgress<double> whole, int count, CancellationToken cancellation) : IJobWatch, IProgress<RenderProgress>
{
    private readonly List<string> _errors = [];
    private int _done;

    /// <summary>Ends the work.</summary>
    public CancellationToken Cancellation => cancellation;

    /// <inheritdoc/>
    public void Warn(string message)
    {
    }

    /// <inheritdoc/>
    public void Fail(string message) => _errors.Add(message);

    /// <inheritdoc/>
    public void Read(IReadOnlyList<Diagnostic> diagnostics) =>
        _errors.AddRange(diagnostics.Where(d => d.Severity == Severity.Error).Select(d => d.Message));

    /// <inheritdoc/>
    public IProgress<RenderProgress> Begin(RenderDescription render) => this;

    /// <inheritdoc/>
    public IImageRows Rows(IImageRows image) => new ReportedRows(image, this);

    /// <inheritdoc/>
    public void Report(RenderProgress value) => Report(value.Fraction);

    /// <summary>A picture is done.</summary>
    public void Next()
    {
        _done++;
        Report(0);
    }

    /// <summary>Returns the outcome of a job, if it was not cancelled and all of its files were written.</summary>
    /// <param name="result">The outcome; null where the scene is wrong.</param>
    /// <param name="frame">The frame that it is of; null where there is one picture only.</param>
    /// <exception cref="OperationCanceledException">It was cancelled.</exception>
    /// <exception cref="JobException">It failed.</exception>
    public JobResult Require(JobResult? result, int? frame = null)
    {
        if (result is null)
        {
            throw new JobException($"this is wrong{(frame is null ? "" : $" at frame {frame}")}: {_errors[0]}");
        }

        if (result.Statistics.Cancelled)
        {
            throw new OperationCanceledException(cancellation);
        }

        RequireWritten();
        return result;
    }

    /// <summary>Makes sure that files were written.</summary>
    /// <exception cref="JobException">One was not.</exception>
    public void RequireWritten()
    {
        if (_errors is [var error, ..])
        {
            throw new JobException(error);
        }
    }

    private void Report(double fraction) => whole.Report((_done + fraction) / count);

    /// <summary>An image whose reader is followed, and can be stopped.</summary>
    private sealed class ReportedRows(IImageRows source, SessionWatch watch) : IImageRows
    {
        private const int Every = 16;

        public int Width => source.Width;

        public int Height => source.Height;

        public void ReadRow(int y, Span<float> rgb)
        {
            watch.Cancellation.ThrowIfCancellationRequested();
            if (y % Every == 0)
            {
                watch.Report((double)y / Height);
            }

            source.ReadRow(y, rgb);
        }
    }
}
