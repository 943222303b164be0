using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>Makes transforms of the directives that take nothing but numbers.</summary>
internal static class PbrtTransforms
{
    /// <summary>How many numbers each directive takes.</summary>
    public static IReadOnlyDictionary<string, int> Counts { get; } = new Dictionary<string, int>(StringComparer.Ordinal)
    {
        ["Translate"] = 3,
        ["Scale"] = 3,
        ["Rotate"] = 4,
        ["LookAt"] = 9,
        ["Transform"] = 16,
        ["ConcatTransform"] = 16,
        ["TransformTimes"] = 2,
    };

    /// <summary>The map of a directive.</summary>
    /// <param name="directive">The directive.</param>
    /// <param name="n">Its numbers, which are finite.</param>
    /// <param name="complaint">What is wrong with the numbers; null where they are only out of range.</param>
    /// <returns>The map; null where there is none.</returns>
    public static Transform? Of(string directive, float[] n, out string? complaint)
    {
        complaint = null;
        switch (directive)
        {
            case "Translate":
                return Transform.Translation(new(n[0], n[1], n[2]));
            case "Scale":
                return Transform.Scaling(new(n[0], n[1], n[2]));
            case "Rotate":
                Vector3 axis = new(n[1], n[2], n[3]);
                complaint = axis.Norm() > 0 && axis.Unit().IsFinite() ? null : "the axis of a rotation must not be 0";
                return complaint is null ? Transform.Rotation(axis, n[0]) : null;
            case "LookAt":
                return LookAt(new(n[0], n[1], n[2]), new(n[3], n[4], n[5]), new(n[6], n[7], n[8]), out complaint);
            default:
                complaint = (n[3], n[7], n[11], n[15]) == (0, 0, 0, 1) ? null : "the last row of a matrix, whose numbers stand column by column, must be 0 0 0 1";
                return complaint is null ? new(new(n[0], n[4], n[8], n[12]), new(n[1], n[5], n[9], n[13]), new(n[2], n[6], n[10], n[14])) : null;
        }
    }

    private static Transform? LookAt(Vector3 eye, Vector3 target, Vector3 up, out string? complaint)
    {
        Transform? frame = LookAtFrame.Of(eye, (target - eye).Unit(), up.Unit());
        complaint = frame is null ? "LookAt needs an eye, another point to look at, and a direction up that does not point from one to the other" : null;
        return frame is { IsInvertible: true } placed ? placed.Inverse() : null;
    }
}
