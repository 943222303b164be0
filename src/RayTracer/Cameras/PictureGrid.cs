using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Cameras;

/// <summary>The pixels of a picture on a plane across the view.</summary>
internal sealed class PictureGrid
{
    private readonly Vector3 _corner;
    private readonly Vector3 _stepX;
    private readonly Vector3 _stepY;
    private readonly Vector3 _perStepX;
    private readonly Vector3 _perStepY;

    /// <summary>Makes one.</summary>
    /// <param name="plane">The upper left corner of the picture, and the steps from pixel to pixel, perpendicular to each other.</param>
    public PictureGrid((Vector3 Corner, Vector3 StepX, Vector3 StepY) plane)
    {
        (_corner, _stepX, _stepY) = plane;
        _perStepX = Inverse(_stepX);
        _perStepY = Inverse(_stepY);
        PixelArea = double.Sqrt(SquaredNorm(_stepX)) * double.Sqrt(SquaredNorm(_stepY));
    }

    /// <summary>The area of a pixel on the plane.</summary>
    public double PixelArea { get; }

    /// <summary>The points of the plane that points of the picture are.</summary>
    public Vec3W At(in FloatW x, in FloatW y) => Vec3W.MultiplyAdd(_stepX, x, Vec3W.MultiplyAdd(_stepY, y, _corner));

    /// <summary>The points of the picture that points of the plane are.</summary>
    public void Find(in Vec3W at, out FloatW x, out FloatW y)
    {
        Vec3W fromCorner = at - _corner;
        x = Vec3W.Dot(fromCorner, _perStepX);
        y = Vec3W.Dot(fromCorner, _perStepY);
    }

    private static double SquaredNorm(Vector3 v) => ((double)v.X * v.X) + ((double)v.Y * v.Y) + ((double)v.Z * v.Z);

    // The vector along another whose scalar product with it is 1.
    private static Vector3 Inverse(Vector3 v)
    {
        double square = SquaredNorm(v);
        return new((float)(v.X / square), (float)(v.Y / square), (float)(v.Z / square));
    }
}
