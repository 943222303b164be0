using System.Numerics;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A point of the screen or of the picture, in pixels.</summary>
internal readonly record struct Spot(double X, double Y)
{
    /// <summary>How far it is from another one.</summary>
    public double DistanceTo(Spot other) => Math.Sqrt(((X - other.X) * (X - other.X)) + ((Y - other.Y) * (Y - other.Y)));

    /// <summary>As a vector.</summary>
    public Vector2 AsVector() => new((float)X, (float)Y);
}
