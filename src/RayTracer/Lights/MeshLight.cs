using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Shapes;

namespace RayTracer.Lights;

/// <summary>
/// The triangles of a space that are made of one luminaire, as one source: a triangle is chosen by area, and a point of it uniformly. The points
/// are moved off their triangles by the offset that rays start with, so that neighbours which bend away from the light cast no shadow on it,
/// while all others may.
/// </summary>
/// <param name="mesh">The table that the triangles are in.</param>
/// <param name="luminaire">Their material.</param>
/// <param name="choice">Chooses a triangle.</param>
/// <param name="instances">The scene's instances; null where the light stands in the world itself.</param>
/// <param name="instance">The instance in which it stands; 0 for the world itself.</param>
internal sealed unsafe class MeshLight(MeshTable mesh, LuminaireMaterial luminaire, TriangleChoice choice, InstanceTable? instances, int instance)
    : LightSource(instance, -1)
{
    // Of each lane: nine coordinates of the corners, six of uv, the probability, the number left for the point.
    private const int Uv = 9;
    private const int Probability = 15;
    private const int Rest = 16;
    private const int Numbers = 17;

    /// <summary>The table that the triangles are in.</summary>
    public MeshTable Mesh => mesh;

    /// <summary>Their material.</summary>
    public LuminaireMaterial Luminaire => luminaire;

    /// <summary>The first of them, among the scene's primitives.</summary>
    public int FirstPrimitive => mesh.FirstPrimitive + choice.Triangles[0];

    /// <inheritdoc/>
    public override void Pdf(in LightHitW hit, out FloatW pdf)
    {
        Meet(hit, out FloatW area, out FloatW probability);
        pdf = AreaSample.Pdf(hit.Distance, hit.Cosine, area) * probability;
    }

    /// <inheritdoc/>
    public override LightExtent Extent((double Open, double Close) shutter)
    {
        Bounds box = choice.Triangles.Aggregate(Bounds.Empty, (all, triangle) =>
        {
            (Vector3 a, Vector3 b, Vector3 c) = mesh.Corners(triangle);
            return all.Union(new(Vector3.Min(a, Vector3.Min(b, c)), Vector3.Max(a, Vector3.Max(b, c))));
        });
        return new(instances?.BoundsOf(Instance, box, shutter) ?? box, luminaire.MeanIntensity * choice.Area);
    }

    /// <inheritdoc/>
    public override void Sample(in Vec3W from, in FloatW u, in FloatW v, in FloatW time, out ShapeSampleW sample, out RgbW radiance)
    {
        float* chosen = stackalloc float[Numbers * 16];
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            Choose(u[lane], chosen + lane);
        }

        Place(chosen, time, out Vec3W a, out Vec3W b, out Vec3W c, out FloatW mirrors);
        Vec3W toB = b - a;
        Vec3W toC = c - a;
        Vec3W normal = Vec3W.Cross(toB, toC) * mirrors;
        FloatW doubled = FloatW.Sqrt(Vec3W.Dot(normal, normal));
        normal *= 1f / doubled;
        Warp.UniformTriangle(Load(chosen, Rest), v, out FloatW atB, out FloatW atC);
        Vec3W point = Vec3W.MultiplyAdd(toC, atC, Vec3W.MultiplyAdd(toB, atB, a));
        FloatW offset = FloatW.Max(Largest(a), FloatW.Max(Largest(b), Largest(c))) * (2f * RayOffset.Relative);
        Vec3W to = Vec3W.MultiplyAdd(normal, offset, point) - from;
        FloatW distance2 = Vec3W.Dot(to, to);
        FloatW inverse = 1f / FloatW.Sqrt(distance2);
        sample.Direction = to * inverse;
        sample.Distance = distance2 * inverse;
        sample.Cosine = -Vec3W.Dot(sample.Direction, normal);
        FloatW weight = sample.Cosine * doubled * 0.5f * inverse * inverse / Load(chosen, Probability);
        sample.InversePdf = (sample.Cosine > 0f).Select(weight, 0f);
        sample.U = Mix(chosen, Uv, atB, atC);
        sample.V = Mix(chosen, Uv + 1, atB, atC);
        luminaire.Emission(sample.Cosine, sample.U, sample.V, out RgbW emitted);
        radiance = emitted * sample.InversePdf;
    }

    /// <inheritdoc/>
    internal override bool CanEmit => true;

    /// <inheritdoc/>
    internal override void Emit(in FloatW u1, in FloatW v1, in FloatW u2, in FloatW v2, in FloatW time, out EmittedW ray)
    {
        float* chosen = stackalloc float[Numbers * 16];
        uint* triangles = stackalloc uint[16];
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            triangles[lane] = (uint)Choose(u1[lane], chosen + lane);
        }

        UIntW triangle = UIntW.Load(triangles);
        Vec3W toB = Corner(chosen, 3) - Corner(chosen, 0);
        Vec3W toC = Corner(chosen, 6) - Corner(chosen, 0);
        Warp.UniformTriangle(Load(chosen, Rest), v1, out FloatW atB, out FloatW atC);
        SurfaceW surface = default;
        surface.Point = Vec3W.MultiplyAdd(toC, atC, Vec3W.MultiplyAdd(toB, atB, Corner(chosen, 0)));
        mesh.Describe(new PrimitiveIndex(triangle, mesh.Stride), luminaire.ConstantColor is null, ref surface);
        FloatW area = Area(toB, toC);
        if (instances is not null)
        {
            float* memory = stackalloc float[InstanceMaps.Floats];
            InstanceMaps maps = new(memory);
            maps.Fill(instances, Instance, time);
            area *= maps.AreaFactor(surface.Normal);
            maps.Describe(hasShading: false, hasTangents: false, ref surface);
        }

        LuminaireEmission.Emit(luminaire, surface, Load(chosen, Probability) / area, u2, v2, out ray);
        ray.Primitive = triangle + (uint)mesh.FirstPrimitive;
        ray.Instance = (uint)Instance;
    }

    /// <inheritdoc/>
    internal override void EmissionPdf(in LightHitW hit, out FloatW point, out FloatW direction)
    {
        Meet(hit, out FloatW area, out FloatW probability);
        point = (hit.Cosine > 0f).Select(probability / area, 0f);
        direction = luminaire.EmissionPdf(hit.Cosine);
    }

    /// <summary>As samples are chosen by area too, they know the density: their triangles, which are not reported, are not needed.</summary>
    internal override void EmissionPdf(in Vec3W from, in ShapeSampleW sample, in FloatW time, out FloatW point, out FloatW direction)
    {
        FloatW inverse = sample.Distance * sample.Distance * sample.InversePdf;
        point = (inverse > 0f).Select(sample.Cosine / inverse, 0f);
        direction = luminaire.EmissionPdf(sample.Cosine);
    }

    private static FloatW Area(in Vec3W toB, in Vec3W toC)
    {
        Vec3W normal = Vec3W.Cross(toB, toC);
        return FloatW.Sqrt(Vec3W.Dot(normal, normal)) * 0.5f;
    }

    // The triangles that were met: their areas in the world, and the probabilities with which they are chosen.
    private void Meet(in LightHitW hit, out FloatW area, out FloatW probability)
    {
        float* met = stackalloc float[Numbers * 16];
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            int triangle = (int)hit.Primitive[lane] - mesh.FirstPrimitive;
            Write(triangle, choice.Probability(triangle), 0, met + lane);
        }

        Place(met, hit.Time, out Vec3W a, out Vec3W b, out Vec3W c, out _);
        area = Area(b - a, c - a);
        probability = Load(met, Probability);
    }

    private static FloatW Load(float* chosen, int number) => FloatW.Load(chosen + (number * FloatW.Count));

    private static Vec3W Corner(float* chosen, int number) => new(Load(chosen, number), Load(chosen, number + 1), Load(chosen, number + 2));

    private static FloatW Mix(float* chosen, int number, FloatW b, FloatW c) =>
        FloatW.MultiplyAdd(Load(chosen, number + 4), c, FloatW.MultiplyAdd(Load(chosen, number + 2), b, Load(chosen, number) * (1f - b - c)));

    private static FloatW Largest(Vec3W p) => FloatW.Max(FloatW.Abs(p.X), FloatW.Max(FloatW.Abs(p.Y), FloatW.Abs(p.Z)));

    // The corners in the world, and −1 where the way there mirrors them.
    private void Place(float* chosen, in FloatW time, out Vec3W a, out Vec3W b, out Vec3W c, out FloatW mirrors)
    {
        a = Corner(chosen, 0);
        b = Corner(chosen, 3);
        c = Corner(chosen, 6);
        mirrors = 1f;
        if (instances is not null)
        {
            float* memory = stackalloc float[InstanceMaps.Floats];
            InstanceMaps maps = new(memory);
            maps.Fill(instances, Instance, time);
            (a, b, c) = (maps.Point(a), maps.Point(b), maps.Point(c));
            mirrors = FloatW.CopySign(1f, maps.Determinant());
        }
    }

    private int Choose(float u, float* to)
    {
        int triangle = choice.Choose(ref u, out float probability);
        Write(triangle, probability, u, to);
        return triangle;
    }

    private void Write(int triangle, float probability, float rest, float* to)
    {
        (Vector3 a, Vector3 b, Vector3 c) = mesh.Corners(triangle);
        (Vector2 uvA, Vector2 uvB, Vector2 uvC) = mesh.UvOf(triangle);
        ReadOnlySpan<float> numbers = [a.X, a.Y, a.Z, b.X, b.Y, b.Z, c.X, c.Y, c.Z, uvA.X, uvA.Y, uvB.X, uvB.Y, uvC.X, uvC.Y, probability, rest];
        for (int i = 0; i < Numbers; i++)
        {
            to[i * FloatW.Count] = numbers[i];
        }
    }
}
