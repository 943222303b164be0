using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>Reads transforms: steps, of which the first one is applied first.</summary>
internal static class MitsubaTransforms
{
    /// <summary>The map of an element's steps; the identity after an error.</summary>
    public static Transform Read(MitsubaElement element, ImportLog log)
    {
        Transform all = Transform.Identity;
        foreach (MitsubaElement step in element.Children)
        {
            if (Step(step, log) is not { } map)
            {
                return Transform.Identity;
            }

            all = map * all;
        }

        if (!all.IsInvertible)
        {
            log.Error(element.Place, "the transform flattens shapes, or has numbers too large or too small to compute with");
            return Transform.Identity;
        }

        return all;
    }

    private static Transform? Step(MitsubaElement step, ImportLog log) => step.Name switch
    {
        "translate" => MitsubaNumbers.Vector(step, 0, log) is { } by ? Transform.Translation(by) : null,
        "scale" => MitsubaNumbers.Vector(step, 1, log) is { } factors ? Transform.Scaling(factors) : null,
        "rotate" => Rotation(step, log),
        "lookat" => LookAt(step, log),
        "matrix" => Matrix(step, log),
        _ => log.Unknown<Transform?>(step.Place, $"<{step.Name}> is not a transform step", step.Name, "translate", "scale", "rotate", "lookat", "matrix"),
    };

    private static Transform? Rotation(MitsubaElement step, ImportLog log)
    {
        if (MitsubaNumbers.Float(step, "angle", log) is not { } angle || MitsubaNumbers.Vector(step, 0, log) is not { } axis)
        {
            return null;
        }

        if (!(axis.Norm() > 0) || !axis.Unit().IsFinite())
        {
            return log.Fail<Transform?>(step.Place, "a rotation needs an axis: x, y or z must be given, and not be 0");
        }

        if (float.Abs(axis.Norm() - 1) > 1e-3f)
        {
            log.Warn(step.Place, "the axis is not of length 1: here this is a rotation about it, but Mitsuba 3 makes it a stretched one");
        }

        return Transform.Rotation(axis, angle);
    }

    private static Transform? LookAt(MitsubaElement step, ImportLog log)
    {
        float[]? origin = MitsubaNumbers.Floats(step, "origin", log, 3);
        float[]? target = MitsubaNumbers.Floats(step, "target", log, 3);
        float[]? up = step.Attributes.ContainsKey("up") ? MitsubaNumbers.Floats(step, "up", log, 3) : [0, 0, 0];
        if (origin is null || target is null || up is null)
        {
            return null;
        }

        Vector3 eye = Vector(origin);
        Vector3 forward = (Vector(target) - eye).Unit();
        if (!forward.IsFinite())
        {
            return log.Fail<Transform?>(step.Place, "origin and target of a lookat must be different points");
        }

        Vector3 upward = Vector(up) == Vector3.Zero ? AnyPerpendicular(forward) : Vector(up);
        return LookAtFrame.Of(eye, forward, upward) ?? log.Fail<Transform?>(step.PlaceOf("up"), "the up direction of a lookat must not point from origin to target");
    }

    private static Transform? Matrix(MitsubaElement step, ImportLog log)
    {
        if (MitsubaNumbers.Floats(step, "value", log, 9, 16) is not { } m)
        {
            return null;
        }

        if (m.Length == 9)
        {
            return new Transform(new(m[0], m[1], m[2], 0), new(m[3], m[4], m[5], 0), new(m[6], m[7], m[8], 0));
        }

        if (!m.AsSpan(12).SequenceEqual([0, 0, 0, 1]))
        {
            return log.Fail<Transform?>(step.PlaceOf("value"), "the last row of a matrix must be 0 0 0 1");
        }

        return new Transform(new(m[0], m[1], m[2], m[3]), new(m[4], m[5], m[6], m[7]), new(m[8], m[9], m[10], m[11]));
    }

    private static Vector3 Vector(float[] v) => new(v[0], v[1], v[2]);

    private static Vector3 AnyPerpendicular(Vector3 direction) =>
        direction.Cross(float.Abs(direction.X) < 0.5f ? Vector3.UnitX : Vector3.UnitY).Unit();
}
