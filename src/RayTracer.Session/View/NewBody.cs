using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>The body of a thing that is put into a scene: how far it reaches, and whether it would cut into what is there.</summary>
internal sealed class NewBody
{
    // Lines through the body along each axis: so many across and down. Between two of them, a twelfth of it may hide.
    private const int Across = 12;
    private const int MostSurfaces = 64;

    // The part of the size by which things may touch.
    private const float Touch = 0.01f;

    // The least cosine between a direction and an axis for which the box is as good as the body.
    private const float Straight = 1 - 1e-5f;

    // How finely, and how often finer, the point is looked for that reaches farthest.
    private const int Samples = 9;
    private const int Zooms = 7;
    private readonly RayProbe _alone;
    private readonly float _touch;
    private readonly List<(Vector3 From, Vector3 Along, float Length)> _lines = [];

    /// <summary>Measures a thing.</summary>
    /// <param name="alone">A scene of nothing else.</param>
    /// <param name="box">The box around it, which has an end.</param>
    /// <param name="size">The size of new things.</param>
    public NewBody(Scene alone, Bounds box, float size)
    {
        (_alone, Box, _touch) = (new(alone), box, Touch * size);
        for (int axis = 0; axis < 3; axis++)
        {
            AddLines(axis);
        }
    }

    /// <summary>The box around it.</summary>
    public Bounds Box { get; }

    /// <summary>The middle of the box.</summary>
    public Vector3 Middle => (Box.Maximum + Box.Minimum) * 0.5f;

    private Vector3 Half => (Box.Maximum - Box.Minimum) * 0.5f;

    /// <summary>Returns whether a surface goes through the inside of the body, or is that of a body just like it at the same place.</summary>
    /// <param name="others">What is there.</param>
    /// <param name="by">By what the body is moved.</param>
    public bool Cuts(RayProbe others, Vector3 by)
    {
        int atBothEnds = 0;
        foreach ((Vector3 from, Vector3 along, float length) in _lines)
        {
            float met = others.Distance(from + by, along);
            if (met < length)
            {
                return true;
            }

            atBothEnds += met < length + (2 * _touch) && others.Distance(from + by, -along) < 2 * _touch ? 1 : 0;
        }

        return 2 * atBothEnds > _lines.Count;
    }

    /// <summary>How far the box reaches from its middle against a direction.</summary>
    /// <param name="up">The unit direction.</param>
    public float Corners(Vector3 up) => Vector3.Abs(up).Dot(Half);

    /// <summary>How far the body reaches from the middle of its box against a direction: on a surface with that normal, it stands so high.</summary>
    /// <param name="up">The unit direction.</param>
    public float Below(Vector3 up)
    {
        float corners = Corners(up);
        if (MathF.Max(MathF.Abs(up.X), MathF.Max(MathF.Abs(up.Y), MathF.Abs(up.Z))) > Straight)
        {
            // The box is exact there.
            return corners;
        }

        Vector3 across = (MathF.Abs(up.Y) < 0.9f ? Vector3.UnitY : Vector3.UnitX).Cross(up).Unit();
        Vector3 down = up.Cross(across);
        float radius = Half.Norm();
        (Vector3 middle, float width, float nearest) = (Middle - (up * (2 * radius)), radius, float.PositiveInfinity);
        for (int zoom = 0; zoom < Zooms; zoom++, width *= 2f / (Samples - 1))
        {
            Vector3 best = middle;
            for (int i = 0; i < Samples * Samples; i++)
            {
                Vector3 from = middle + (across * (width * At(i % Samples))) + (down * (width * At(i / Samples)));
                float met = _alone.Distance(from, up);
                (best, nearest) = met < nearest ? (from, met) : (best, nearest);
            }

            middle = best;
        }

        return float.IsFinite(nearest) ? MathF.Min(corners, (2 * radius) - nearest) : corners;

        static float At(int i) => (2f * i / (Samples - 1)) - 1;
    }

    private void AddLines(int axis)
    {
        (Vector3 along, Vector3 extent) = (default, Box.Maximum - Box.Minimum);
        along[axis] = 1;
        (int second, int third) = ((axis + 1) % 3, (axis + 2) % 3);
        for (int i = 0; i < Across * Across; i++)
        {
            Vector3 from = Box.Minimum;
            from[second] += extent[second] * (((i % Across) + 0.5f) / Across);
            from[third] += extent[third] * (((i / Across) + 0.5f) / Across);
            from[axis] -= _touch;
            foreach ((float start, float end) in Inside(from, along))
            {
                _lines.Add((from + (along * (start + _touch)), along, end - start - (2 * _touch)));
            }
        }
    }

    // From each surface at which the ray comes in to that at which it goes out.
    private IEnumerable<(float Start, float End)> Inside(Vector3 from, Vector3 along)
    {
        (float at, float? start) = (0, null);
        for (int i = 0; i < MostSurfaces && _alone.Distance(from + (along * at), along) is var met && float.IsFinite(met); i++)
        {
            float surface = at + met;
            if (start is { } begin && surface - begin > 2 * _touch)
            {
                yield return (begin, surface);
            }

            start = start is null ? surface : null;
            at = surface + (0.01f * _touch);
        }
    }
}
