using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Study;

/// <summary>
/// Equal boxes, each with a list of the triangles in it; a ray walks from box to box (Fujimoto, Tanaka &amp; Iwata 1986; Amanatides &amp;
/// Woo 1987). Twice as many boxes as triangles, so that a ray passes about as many as the cube root of their number.
/// </summary>
internal sealed class UniformGrid : Accelerator
{
    private const float BoxesPerTriangle = 2;
    private const int MostAlongAxis = 1024;

    // Triangles are listed in boxes that they nearly touch as well, for the walk may err by a rounding.
    private const float Margin = 1e-3f;

    // Of coordinates: a wall, a point of the ray, a box around a triangle and its margin are rounded, a few times each.
    private const float Roundings = 8 * 1.1920929e-7f;
    private readonly Bounds _bounds;
    private readonly Vector3 _boxSize;
    private readonly float _rounding;
    private readonly int[] _sides = new int[3];
    private readonly int[] _first;
    private readonly int[] _listed;

    /// <summary>Builds the grid.</summary>
    /// <param name="mesh">The triangles.</param>
    public UniformGrid(MeshData mesh)
        : base(mesh)
    {
        // A flat scene has a little height, lest it be one layer of endlessly many boxes.
        Bounds tight = BoundsOfAll();
        _rounding = Roundings * Vector3.Max(Vector3.Abs(tight.Minimum), Vector3.Abs(tight.Maximum)).Largest();
        Vector3 pad = new((0.5e-3f * (tight.Maximum - tight.Minimum).Largest()) + _rounding);
        _bounds = Count == 0 ? new(Vector3.Zero, Vector3.One) : new(tight.Minimum - pad, tight.Maximum + pad);
        Vector3 extent = _bounds.Maximum - _bounds.Minimum;
        float perUnit = LaneMath.Pow(BoxesPerTriangle * Count / extent.X / extent.Y / extent.Z, 1 / 3f);
        for (int axis = 0; axis < 3; axis++)
        {
            _sides[axis] = Math.Clamp((int)(extent[axis] * perUnit), 1, MostAlongAxis);
        }

        _boxSize = extent / new Vector3(_sides[0], _sides[1], _sides[2]);

        // Count, add up, fill in.
        int boxes = _sides[0] * _sides[1] * _sides[2];
        _first = new int[boxes + 1];
        ForEachBox((box, _) => _first[box]++);
        int total = 0;
        for (int box = 0; box <= boxes; box++)
        {
            total += _first[box];
            _first[box] = total;
        }

        _listed = new int[total];
        ForEachBox((box, triangle) => _listed[--_first[box]] = triangle);
    }

    /// <inheritdoc/>
    public override string Name => "uniform grid";

    /// <inheritdoc/>
    public override long MemoryBytes => sizeof(int) * ((long)_first.Length + _listed.Length);

    /// <inheritdoc/>
    public override int ClosestHit(in Ray ray, ref float distance)
    {
        (float begin, float end) = ray.Within(_bounds.Minimum, _bounds.Maximum);
        int hit = -1;
        Span<int> box = stackalloc int[3];
        for (int axis = 0; axis < 3; axis++)
        {
            box[axis] = BoxAlong(axis, float.FusedMultiplyAdd(ray.Direction[axis], begin, ray.Origin[axis]));
        }

        while (begin <= end && begin <= distance)
        {
            int at = (((box[2] * _sides[1]) + box[1]) * _sides[0]) + box[0];
            for (int i = _first[at]; i < _first[at + 1]; i++)
            {
                Meet(_listed[i], ray, ref distance, ref hit);
            }

            // On through the nearest of the three walls ahead.
            int axis = 0;
            float next = float.PositiveInfinity;
            for (int k = 0; k < 3; k++)
            {
                float wall = _bounds.Minimum[k] + ((box[k] + (ray.Direction[k] > 0 ? 1 : 0)) * _boxSize[k]);
                float t = ray.Direction[k] == 0 ? float.PositiveInfinity : (wall - ray.Origin[k]) * ray.Inverse[k];
                (axis, next) = t < next ? (k, t) : (axis, next);
            }

            begin = next;
            box[axis] += ray.Direction[axis] > 0 ? 1 : -1;
            if ((uint)box[axis] >= (uint)_sides[axis])
            {
                break;
            }
        }

        return hit;
    }

    private int BoxAlong(int axis, float coordinate) =>
        Math.Clamp((int)((coordinate - _bounds.Minimum[axis]) / _boxSize[axis]), 0, _sides[axis] - 1);

    // In the order of falling numbers, so that lists that are filled from behind are ascending.
    private void ForEachBox(Action<int, int> action)
    {
        Vector3 margin = (_boxSize * Margin) + new Vector3(_rounding);
        for (int triangle = Count - 1; triangle >= 0; triangle--)
        {
            Bounds b = BoundsOf(triangle);
            (Vector3 low, Vector3 high) = (b.Minimum - margin, b.Maximum + margin);
            for (int z = BoxAlong(2, low.Z); z <= BoxAlong(2, high.Z); z++)
            {
                for (int y = BoxAlong(1, low.Y); y <= BoxAlong(1, high.Y); y++)
                {
                    for (int x = BoxAlong(0, low.X); x <= BoxAlong(0, high.X); x++)
                    {
                        action((((z * _sides[1]) + y) * _sides[0]) + x, triangle);
                    }
                }
            }
        }
    }
}
