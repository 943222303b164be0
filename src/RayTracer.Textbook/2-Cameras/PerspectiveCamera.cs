namespace RayTracer.Textbook;

/// <summary>
/// An eye that looks through a window (report, section 3.2). With a lens, rays start on a disk around the eye, and all those of a point of the
/// window meet in the plane in focus (section 6.2.3): what is elsewhere is blurred.
/// </summary>
/// <param name="eye">The middle of the lens.</param>
/// <param name="forward">Where it looks; of length 1, as the next two.</param>
/// <param name="right">To the right in the picture.</param>
/// <param name="up">Upwards in the picture.</param>
/// <param name="width">Width of the picture in pixels.</param>
/// <param name="height">Height of the picture in pixels.</param>
/// <param name="pixelSize">Side of a pixel of a window at distance 1.</param>
/// <param name="lens">The lens.</param>
/// <param name="focus">Distance of the plane in focus.</param>
public sealed class PerspectiveCamera(
    Vector eye, Vector forward, Vector right, Vector up, int width, int height, double pixelSize, ILens lens, double focus) : ICamera
{
    /// <inheritdoc/>
    public Ray RayThrough(double x, double y, ISampler sampler)
    {
        Vector window = forward + (right * ((x - (0.5 * width)) * pixelSize)) + (up * (((0.5 * height) - y) * pixelSize));
        Vector onLens = eye + lens.Point(sampler);
        Vector inFocus = eye + (window * focus);
        return new(onLens, (inFocus - onLens).Unit);
    }

    /// <inheritdoc/>
    public Sight? Find(Vector point, ISampler sampler)
    {
        Vector shift = lens.Point(sampler);
        Vector onLens = eye + shift;
        Vector along = point - onLens;
        double depth = Vector.Dot(along, forward);
        if (depth <= 0)
        {
            return null;
        }

        // Where the ray from the lens through the point crosses the plane in focus, and so the window, which is that plane at distance 1. The
        // report's eye may be nearer to the plane than the middle of its box.
        double nearer = 1 - (Vector.Dot(shift, forward) / focus);
        Vector window = (shift * (1 / focus)) + (along * (nearer / depth));
        double x = (0.5 * width) + (Vector.Dot(window, right) / pixelSize);
        double y = (0.5 * height) - (Vector.Dot(window, up) / pixelSize);
        if (x < 0 || x >= width || y < 0 || y >= height)
        {
            return null;
        }

        // A pixel at distance 1 covers its area times cos³, in steradians; areas at the point grow with the squared distance.
        double distance2 = Vector.Dot(along, along);
        double cosine = depth / Math.Sqrt(distance2);
        return new Sight(onLens, x, y, nearer * nearer / (pixelSize * pixelSize * cosine * cosine * cosine * distance2));
    }
}
