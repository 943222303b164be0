using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>Transforms as descriptions have them.</summary>
internal static class MatrixSteps
{
    /// <summary>The steps of a transform: none, or one matrix.</summary>
    public static IReadOnlyList<TransformDescription> Of(in Transform place) => place.IsIdentity ? [] : [new() { Matrix = Matrix(place) }];

    private static float[] Matrix(in Transform m)
    {
        IEnumerable<double> numbers = new[] { m.X, m.Y, m.Z }.SelectMany(r => new[] { r.A, r.B, r.C, r.D });
        return [.. numbers.Select(n => (float)n)];
    }
}
