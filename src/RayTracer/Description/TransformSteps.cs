using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Description;

/// <summary>Turns the steps and keyframes of descriptions into maps, and reports those that cannot be computed with.</summary>
internal static class TransformSteps
{
    /// <summary>The motion of a thing: its transform, then its keyframes.</summary>
    /// <param name="subject">The record that the steps and keyframes belong to.</param>
    /// <param name="steps">The transform.</param>
    /// <param name="keyframes">The keyframes.</param>
    /// <param name="builder">Takes the diagnostics.</param>
    public static Motion Motion(object subject, IReadOnlyList<TransformDescription> steps, IReadOnlyList<KeyframeDescription> keyframes, SceneBuilder builder)
    {
        Motion place = Numerics.Motion.Still(Place(subject, steps, builder));
        return keyframes.Count == 0 ? place : Keyframes(keyframes, builder) * place;
    }

    /// <summary>The map of some steps, the first one applied first.</summary>
    public static Transform Place(object subject, IReadOnlyList<TransformDescription> steps, SceneBuilder builder)
    {
        Transform all = Transform.Identity;
        foreach (TransformDescription step in steps)
        {
            all = Step(step, builder) * all;
        }

        if (!all.IsInvertible)
        {
            builder.Error(subject, "Transform", "the steps of the transform together have numbers too large or too small to compute with");
            return Transform.Identity;
        }

        return all;
    }

    private static Motion Keyframes(IReadOnlyList<KeyframeDescription> keyframes, SceneBuilder builder)
    {
        for (int i = 1; i < keyframes.Count; i++)
        {
            if (!(keyframes[i].Time > keyframes[i - 1].Time))
            {
                builder.Error(keyframes[i], nameof(KeyframeDescription.Time), $"keyframes must be in the order of their times, but {keyframes[i].Time} follows {keyframes[i - 1].Time}");
                return Numerics.Motion.None;
            }
        }

        (double Time, Transform Place)[] places = [.. keyframes.Select(k => ((double)k.Time, Place(k, k.Transform, builder)))];
        for (int i = 1; i < places.Length; i++)
        {
            if (places[i].Place.Determinant < 0 != places[i - 1].Place.Determinant < 0)
            {
                builder.Error(keyframes[i], nameof(KeyframeDescription.Transform), "between these keyframes the thing would be turned inside out: one of them mirrors and the other does not");
                return Numerics.Motion.None;
            }
        }

        return Numerics.Motion.Between(places);
    }

    private static Transform Step(TransformDescription step, SceneBuilder builder)
    {
        Transform matrix = Matrix(step, builder);
        if (step.Scale.X * step.Scale.Y * step.Scale.Z == 0)
        {
            builder.Error(step, nameof(TransformDescription.Scale), "no factor of \"scale\" may be 0, or so small that their product rounds to 0");
            return Transform.Identity;
        }

        Transform turned = Transform.Scaling(step.Scale) * matrix;
        if (step.Rotate != 0)
        {
            if (!(step.Axis.Norm() > 0) || !step.Axis.Unit().IsFinite())
            {
                builder.Error(step, nameof(TransformDescription.Axis), "the axis must have a length, but it is (or rounds to) [0, 0, 0]");
                return Transform.Identity;
            }

            turned = Transform.Rotation(step.Axis, step.Rotate) * turned;
        }

        return Transform.Translation(step.Translate) * turned;
    }

    private static Transform Matrix(TransformDescription step, SceneBuilder builder)
    {
        IReadOnlyList<float> m = step.Matrix;
        if (m.Count == 0)
        {
            return Transform.Identity;
        }

        if (m.Count is not (12 or 16))
        {
            builder.Error(step, nameof(TransformDescription.Matrix), $"a matrix has 12 or 16 numbers, but this one has {m.Count}");
            return Transform.Identity;
        }

        if (m.Count == 16 && !m.Skip(12).SequenceEqual([0, 0, 0, 1]))
        {
            builder.Error(step, nameof(TransformDescription.Matrix), "the last row of a matrix must be 0, 0, 0, 1");
            return Transform.Identity;
        }

        Transform matrix = new(Row(m, 0), Row(m, 4), Row(m, 8));
        if (!matrix.IsInvertible)
        {
            builder.Error(step, nameof(TransformDescription.Matrix), "the matrix flattens shapes: its determinant is 0, or it rounds to 0");
            return Transform.Identity;
        }

        return matrix;
    }

    private static TransformRow Row(IReadOnlyList<float> m, int first) => new(m[first], m[first + 1], m[first + 2], m[first + 3]);
}
