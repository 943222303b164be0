namespace RayTracer.Textbook;

/// <summary>Parallel rays: everything is as large as if it were near.</summary>
/// <param name="eye">The middle of the window from which rays start.</param>
/// <param name="forward">Where it looks; of length 1, as the next two.</param>
/// <param name="right">To the right in the picture.</param>
/// <param name="up">Upwards in the picture.</param>
/// <param name="width">Width of the picture in pixels.</param>
/// <param name="height">Height of the picture in pixels.</param>
/// <param name="pixelSize">Side of a pixel of the window.</param>
public sealed class OrthographicCamera(Vector eye, Vector forward, Vector right, Vector up, int width, int height, double pixelSize) : ICamera
{
    /// <inheritdoc/>
    public Ray RayThrough(double x, double y, ISampler sampler) =>
        new(eye + (right * ((x - (0.5 * width)) * pixelSize)) + (up * (((0.5 * height) - y) * pixelSize)), forward);

    /// <inheritdoc/>
    public Sight? Find(Vector point, ISampler sampler)
    {
        Vector from = point - eye;
        double depth = Vector.Dot(from, forward);
        double x = (0.5 * width) + (Vector.Dot(from, right) / pixelSize);
        double y = (0.5 * height) - (Vector.Dot(from, up) / pixelSize);
        bool isSeen = depth > 0 && x >= 0 && x < width && y >= 0 && y < height;
        return isSeen ? new Sight(point - (depth * forward), x, y, 1 / (pixelSize * pixelSize)) : null;
    }
}
