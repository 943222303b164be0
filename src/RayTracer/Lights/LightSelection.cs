using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Lights;

/// <summary>
/// Chooses one of many lights for a lit point, in a time that grows with the logarithm of their number: down a binary tree over them, at each node to either
/// side in proportion to what it may bring (after Conty Estevez &amp; Kulla 2018, section 4; without cones of normals): its strength times a mean cosine over a
/// mean squared distance. Lights infinitely far away stand beside the tree. Probabilities are computed in the same way both times.
/// </summary>
internal sealed unsafe class LightSelection
{
    // Of each node of the tree: middle and half the size of its box, and its strength. The root is 0, and the two children of a node
    // stand side by side.
    private const int Numbers = 7;
    private const float Faintest = 1e-12f;
    private const uint IsLeaf = 0x80000000;
    private readonly PinnedBuffer<float> _nodes;

    // Of each node: its first child, or with a bit the light of a leaf. Of each light: the steps down to it, lowest bit first; and its
    // place among those far away.
    private readonly PinnedBuffer<uint> _children;
    private readonly PinnedBuffer<uint> _trails;
    private readonly PinnedBuffer<float> _strengthsFar;
    private readonly int[] _far;
    private readonly float _sumFar;
    private readonly int _depth;
    private int _count;

    /// <summary>Builds the tree.</summary>
    /// <param name="lights">The lights.</param>
    /// <param name="shutter">When the shutter opens and closes, in seconds.</param>
    public LightSelection(IReadOnlyList<LightSource> lights, (double Open, double Close) shutter)
    {
        LightExtent[] extents = [.. lights.Select(l => l.Extent(shutter))];

        // Beside the brightest; what is too bright to be measured counts as that, and what has any light is never forgotten.
        float largest = extents.Max(e => float.IsFinite(e.Strength) ? e.Strength : 0);
        float[] strengths = [.. extents.Select(e => e.Strength <= 0 ? 0 : e.Strength < largest ? float.Max(e.Strength / largest, Faintest) : 1)];
        _far = [.. Enumerable.Range(0, extents.Length).Where(i => !extents[i].Box.IsFinite)];
        int[] near = [.. Enumerable.Range(0, extents.Length).Where(i => extents[i].Box.IsFinite)];
        _strengthsFar = new(lights.Count);
        foreach (int i in _far)
        {
            _strengthsFar.Pointer[i] = strengths[i];
            _sumFar += strengths[i];
        }

        _nodes = new((long)Numbers * 2 * Math.Max(near.Length, 1));
        _children = new(2L * Math.Max(near.Length, 1));
        _trails = new(lights.Count);
        _count = 1;
        if (near.Length > 0)
        {
            Vector3[] middles = [.. extents.Select(e => (0.5f * e.Box.Minimum) + (0.5f * e.Box.Maximum))];
            _depth = Build(0, near, new(extents, strengths, middles), 0, 0);
        }
        else
        {
            _children.Pointer[0] = IsLeaf;
        }
    }

    /// <summary>Chooses a light for each lit point.</summary>
    /// <param name="point">The points.</param>
    /// <param name="normal">Unit normals on the side that is lit; zero where light from all sides counts.</param>
    /// <param name="u">Random numbers.</param>
    /// <param name="light">Numbers of the lights.</param>
    /// <param name="probability">With which they were chosen; zero where no light can reach the point.</param>
    public void Choose(in Vec3W point, in Vec3W normal, FloatW u, out UIntW light, out FloatW probability)
    {
        FloatW near = NearShare(point, normal);
        MaskW isNear = u < near;
        probability = isNear.Select(near, 1f - near);
        u = Rest(isNear.Select(u, u - near), probability);
        UIntW node = 0u;
        FloatW descended = 1f;
        for (int level = 0; level < _depth; level++)
        {
            UIntW first = UIntW.Gather(_children.Pointer, node);
            MaskW isInner = UIntW.Equal(first & IsLeaf, 0u);
            if (!isInner.Any)
            {
                break;
            }

            first = isInner.Select(first, 0u);
            FloatW left = LeftShare(first, point, normal);
            MaskW goesLeft = u < left;
            FloatW taken = goesLeft.Select(left, 1f - left);
            descended *= isInner.Select(taken, 1f);
            u = isInner.Select(Rest(goesLeft.Select(u, u - left), taken), u);
            node = isInner.Select(goesLeft.Select(first, first + 1u), node);
        }

        light = UIntW.Gather(_children.Pointer, node) & ~IsLeaf;
        probability *= isNear.Select(descended, 1f);
        if (_far.Length > 0)
        {
            ChooseFar(isNear, u, ref light, ref probability);
        }
    }

    /// <summary>The probability with which a light is chosen for each lit point.</summary>
    /// <param name="point">The points.</param>
    /// <param name="normal">Unit normals on the side that is lit; zero where light from all sides counts.</param>
    /// <param name="light">Numbers of the lights.</param>
    /// <param name="probability">The probability.</param>
    public void Probability(in Vec3W point, in Vec3W normal, in UIntW light, out FloatW probability)
    {
        FloatW near = NearShare(point, normal);
        FloatW far = FloatW.Gather(_strengthsFar.Pointer, light);
        MaskW isFar = IsFar(light);
        UIntW trail = UIntW.Gather(_trails.Pointer, light);
        UIntW node = 0u;
        probability = isFar.Select((1f - near) * far * (1f / Math.Max(_sumFar, float.Epsilon)), near);
        for (int level = 0; level < _depth; level++)
        {
            UIntW first = UIntW.Gather(_children.Pointer, node);
            MaskW isInner = UIntW.Equal(first & IsLeaf, 0u).Except(isFar);
            if (!isInner.Any)
            {
                break;
            }

            first = isInner.Select(first, 0u);
            FloatW left = LeftShare(first, point, normal);
            MaskW goesLeft = UIntW.Equal(trail & 1u, 0u);
            probability *= isInner.Select(goesLeft.Select(left, 1f - left), 1f);
            node = isInner.Select(goesLeft.Select(first, first + 1u), node);
            trail >>= 1;
        }
    }

    private static FloatW Rest(FloatW u, FloatW width) => FloatW.Min((width > 0f).Select(u / width, 0f), float.BitDecrement(1));

    // Far lights are few: one after the other.
    private void ChooseFar(MaskW isNear, FloatW u, ref UIntW light, ref FloatW probability)
    {
        FloatW left = u * _sumFar;
        MaskW waits = ~isNear;
        for (int i = 0; i < _far.Length; i++)
        {
            float strength = _strengthsFar.Pointer[_far[i]];
            MaskW taken = waits & (i == _far.Length - 1 ? MaskW.All : left < strength);
            light = taken.Select((UIntW)(uint)_far[i], light);
            probability = taken.Select(probability * (strength / _sumFar), probability);
            waits = waits.Except(taken);
            left -= strength;
        }
    }

    private MaskW IsFar(UIntW light)
    {
        MaskW far = MaskW.None;
        foreach (int i in _far)
        {
            far |= UIntW.Equal(light, (uint)i);
        }

        return far;
    }

    // The probability of the tree as against what is infinitely far away.
    private FloatW NearShare(in Vec3W point, in Vec3W normal)
    {
        if (_far.Length == 0)
        {
            return 1f;
        }

        FloatW root = Importance(0u, point, normal);
        FloatW sum = root + _sumFar;
        return (sum > 0f).Select(root / sum, 0.5f);
    }

    // The probability of the first of two children. Where neither can bring anything, they are alike.
    private FloatW LeftShare(UIntW first, in Vec3W point, in Vec3W normal)
    {
        FloatW left = Importance(first, point, normal);
        FloatW right = Importance(first + 1u, point, normal);
        FloatW sum = left + right;
        return (sum > 0f).Select(left / sum, 0.5f);
    }

    private FloatW Importance(UIntW node, in Vec3W point, in Vec3W normal)
    {
        UIntW at = node * (uint)Numbers;
        float* numbers = _nodes.Pointer;
        Vec3W to = Vec3W.Gather(numbers, at) - point;
        Vec3W half = Vec3W.Gather(numbers + 3, at);
        FloatW distance2 = Vec3W.Dot(to, to);
        FloatW size2 = Vec3W.Dot(half, half);

        // The square of the distance to half of the box, and what the lights' distances vary by if they fill it: the distance to the middle alone would not
        // tell near lights of a large box from far ones (the variance of the choice among 10,000 lamps was more than ten times as large).
        Vec3W outside = new(
            FloatW.Max(FloatW.Abs(to.X) - (half.X * 0.5f), 0f), FloatW.Max(FloatW.Abs(to.Y) - (half.Y * 0.5f), 0f), FloatW.Max(FloatW.Abs(to.Z) - (half.Z * 0.5f), 0f));
        FloatW square = FloatW.MultiplyAdd(size2, 1f / 12, Vec3W.Dot(outside, outside));

        // The height halfway from the middle of the box to its highest corner: above zero where any light can be above the horizon, whatever rounding takes.
        FloatW middle = Vec3W.Dot(to, normal);
        FloatW corner = (half.X * FloatW.Abs(normal.X)) + (half.Y * FloatW.Abs(normal.Y)) + (half.Z * FloatW.Abs(normal.Z));
        FloatW reach2 = FloatW.MultiplyAdd(size2, 1f / 3, distance2);
        FloatW reach = FloatW.Sqrt(reach2);
        FloatW top = FloatW.Max(middle + corner + (reach * 1e-5f), 0f);
        FloatW height = (top > 0f).Select((FloatW.Max(middle, 0f) + top) * 0.5f, 0f);
        FloatW cosine = (Vec3W.Dot(normal, normal) <= 0f).Select(1f, FloatW.Min(height / FloatW.Max(reach, 1e-30f), 1f));
        return FloatW.Gather(numbers + 6, at) * cosine / FloatW.Max(square, 1e-30f);
    }

    // Halves at the middle one along the longest side of the box around the middles; returns the number of levels below.
    private int Build(int node, Span<int> lights, in Builder builder, uint trail, int level)
    {
        Bounds box = Bounds.Empty;
        Bounds middles = Bounds.Empty;
        double strength = 0;
        foreach (int light in lights)
        {
            box = box.Union(builder.Extents[light].Box);
            middles = middles.Union(new(builder.Middles[light], builder.Middles[light]));
            strength += builder.Strengths[light];
        }

        Write(node, box, (float)strength);
        if (lights.Length == 1)
        {
            _children.Pointer[node] = (uint)lights[0] | IsLeaf;
            _trails.Pointer[lights[0]] = trail;
            return 0;
        }

        Vector3 size = middles.Maximum - middles.Minimum;
        int axis = size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
        Vector3[] places = builder.Middles;
        lights.Sort((a, b) => places[a][axis].CompareTo(places[b][axis]) is not 0 and var order ? order : a.CompareTo(b));
        int half = lights.Length / 2;
        int first = _count;
        _count += 2;
        _children.Pointer[node] = (uint)first;
        int left = Build(first, lights[..half], builder, trail, level + 1);
        return 1 + Math.Max(left, Build(first + 1, lights[half..], builder, trail | (1u << level), level + 1));
    }

    private void Write(int node, in Bounds box, float strength)
    {
        Vector3 middle = (0.5f * box.Minimum) + (0.5f * box.Maximum);
        Vector3 half = 0.5f * (1 + 1e-5f) * (box.Maximum - box.Minimum);
        new ReadOnlySpan<float>([middle.X, middle.Y, middle.Z, half.X, half.Y, half.Z, strength]).CopyTo(new Span<float>(_nodes.Pointer + (Numbers * node), Numbers));
    }

    private readonly record struct Builder(LightExtent[] Extents, float[] Strengths, Vector3[] Middles);
}
