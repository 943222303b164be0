using System.Numerics;
using RayTracer.Media;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Finds what a point is in, by following rays from it outwards: shapes that more rays leave than enter are around it.</summary>
internal sealed unsafe class EnclosingMedia
{
    private const int Directions = 14;
    private const int MostHits = 1000;

    // As many as a path can track.
    private const int MostShapes = 3;
    private readonly Scene _scene;
    private readonly Vec3W _origin;
    private readonly PinnedBuffer<int> _hits;
    private PathStream _rays = new(16);
    private PathStream _next = new(16);

    // For each interior: how often rays left it more than they entered it, and how many met it; and how far it was where it was left.
    private readonly int[] _left;
    private readonly int[] _met;
    private readonly float[] _distance;

    private EnclosingMedia(Scene scene, in Vec3W origin)
    {
        (_scene, _origin) = (scene, origin);
        _hits = new(scene.World.RoomForHits(16));
        int interiors = 1 + (int)scene.Groups.Max(g => g.Interior);
        (_left, _met, _distance) = (new int[interiors], new int[interiors], new float[interiors]);
        Array.Fill(_distance, float.PositiveInfinity);
    }

    /// <summary>The media that a scene's camera stands in, where it is when the shutter opens.</summary>
    /// <param name="scene">A scene whose interiors have numbers.</param>
    public static uint Of(Scene scene) => At(scene, scene.Camera.Origin(scene.Render.Shutter.X));

    /// <summary>The media around a point, when the shutter opens.</summary>
    /// <param name="scene">A scene whose interiors have numbers.</param>
    /// <param name="point">The point.</param>
    public static uint At(Scene scene, in Vec3W point) => new EnclosingMedia(scene, point).Find();

    private uint Find()
    {
        for (int i = 0; i < Directions; i++)
        {
            Follow(i);
        }

        // The furthest comes first, as if the camera had come in from outside. What rays meet from both sides, such as a plane, is around where most say so;
        // of shapes of one interior that overlap, there are several around.
        UIntW stack = 0u;
        foreach (int interior in Enumerable.Range(0, _left.Length).OrderByDescending(i => _distance[i]))
        {
            for (int shape = 0; shape < MostShapes && _left[interior] * 2 > _met[interior] * ((2 * shape) + 1); shape++)
            {
                stack = _scene.Cross(stack, (uint)interior, MaskW.All, MaskW.All);
            }
        }

        return MediumStack.Scattered(stack)[0];
    }

    private void Follow(int number)
    {
        _rays.Count = 0;
        Append(_rays, _origin, Direction(number));
        int[] left = new int[_left.Length];
        bool[] met = new bool[_left.Length];
        float way = 0;
        for (int hit = 0; hit < MostHits && _rays.Count > 0; hit++)
        {
            _scene.World.ClosestHit(_rays, _hits.Pointer);
            _next.Count = 0;
            way += _rays.Distance[0];
            Step(way, left, met);
            (_rays, _next) = (_next, _rays);
        }

        for (int i = 1; i < left.Length; i++)
        {
            _met[i] += met[i] ? 1 : 0;
            _left[i] += Math.Max(left[i], 0);
        }
    }

    private void Step(float way, int[] left, bool[] met)
    {
        int number = _scene.GroupOfPrimitive[(int)_rays.Primitive[0]];
        if (number >= _scene.Groups.Length)
        {
            return;
        }

        uint* index = stackalloc uint[16];
        new Span<uint>(index, 16).Clear();
        ShadingGroup group = _scene.Groups[number];
        SurfaceShader.Describe(_scene, group, _rays, index, group.Traits.UsesUv, out Materials.SurfaceW surface);
        uint interior = group.Interior;
        if (interior != 0)
        {
            bool leaves = SurfaceShader.ComesFromInside(surface).Bits != 0;
            left[interior] += leaves ? 1 : -1;
            met[interior] = true;
            _distance[interior] = leaves && left[interior] > 0 ? float.Min(_distance[interior], way) : _distance[interior];
        }

        Append(_next, SurfaceShader.Leave(surface, surface.Incoming), surface.Incoming);
        if (group.IsInstanced)
        {
            _next.SetStart(1u, surface.Instance, SurfaceShader.LeaveInside(surface, surface.Incoming));
        }
    }

    private void Append(PathStream to, in Vec3W origin, in Vec3W direction)
    {
        if (_scene.IsTimed)
        {
            to.SetTime(1u, _scene.Render.Shutter.X);
        }

        to.Append(1u, origin, direction, Rgb.White, Rgb.Black, 0u, 0u);
    }

    // The corners of a cube and the middles of its faces, turned so that they lie in no plane that scenes are likely to have.
    private static Vec3W Direction(int number)
    {
        Vector3 even = number < 8
            ? new((number & 1) == 0 ? 1 : -1, (number & 2) == 0 ? 1 : -1, (number & 4) == 0 ? 1 : -1)
            : new Vector3(number / 2 == 4 ? 1 : 0, number / 2 == 5 ? 1 : 0, number / 2 == 6 ? 1 : 0) * ((number & 1) == 0 ? 1 : -1);
        Vector3 turned = new(
            even.X - (0.231f * even.Y) + (0.117f * even.Z),
            (0.231f * even.X) + even.Y - (0.173f * even.Z),
            (-0.117f * even.X) + (0.173f * even.Y) + even.Z);
        return turned.Unit();
    }
}
