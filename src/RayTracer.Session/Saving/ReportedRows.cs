using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>An image that tells how far its reader is, and can stop it.</summary>
/// <param name="source">The image.</param>
/// <param name="progress">Told how far, 0 to 1.</param>
/// <param name="cancellation">Stops the reader.</param>
internal sealed class ReportedRows(IImageRows source, IProgress<double> progress, CancellationToken cancellation) : IImageRows
{
    private const int Every = 16;

    public int Width => source.Width;

    public int Height => source.Height;

    public void ReadRow(int y, Span<float> rgb)
    {
        cancellation.ThrowIfCancellationRequested();
        if (y % Every == 0)
        {
            progress.Report((double)y / Height);
        }

        source.ReadRow(y, rgb);
    }
}
