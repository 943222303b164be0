using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Shapes;

namespace RayTracer.RenderTests.Bits;

/// <summary>Trees of some depth: a bumpy ground of 1,800 triangles, and 60 instances of a small piece of it at all angles above.</summary>
internal static class HillScene
{
    /// <summary>Makes the scene, lit by its sky.</summary>
    public static Scene Build()
    {
        MeshDescription piece = new() { Data = Ground(6) };
        InstanceDescription[] pieces = [.. Enumerable.Range(0, 60).Select(i => new InstanceDescription
        {
            Of = piece,
            Transform = [new() { Scale = new(0.12f, 0.25f, i % 3 == 0 ? -0.1f : 0.1f), Rotate = 37 * i, Axis = new(1, i % 5, i % 3), Translate = new((i % 10 * 0.4f) - 1.8f, 0.5f + (i % 7 * 0.1f), (i / 10 * 0.5f) - 1.5f) }],
        })];
        SceneDescription description = new()
        {
            Camera = new() { Position = new(0, 2, 4), LookAt = new(0, 0.3f, 0), FieldOfView = 45 },
            Render = new() { Integrator = Integrator.Report, Width = 32, Height = 24, SamplesPerPixel = 4 },
            Background = new Rgb(0.8f, 0.9f, 1f),
            Shapes = [new MeshDescription { Data = Ground(30), Transform = [new() { Scale = new(2, 1, 2) }] }, .. pieces],
        };
        return new SceneBuilder((_, _) => throw new NotSupportedException()).Build(description)!;
    }

    // Squares of two triangles from −1 to 1, of heights without a pattern.
    private static MeshData Ground(int edge)
    {
        Vector3[] positions = [.. Enumerable.Range(0, (edge + 1) * (edge + 1)).Select(i => new Vector3(
            (2f * (i % (edge + 1)) / edge) - 1, i * i % 97 / 500f, (2f * (i / (edge + 1)) / edge) - 1))];
        int[] indices = [.. Enumerable.Range(0, edge * edge).SelectMany(i =>
        {
            int a = (i / edge * (edge + 1)) + (i % edge);
            return new[] { a, a + edge + 1, a + 1, a + 1, a + edge + 1, a + edge + 2 };
        })];
        return new(positions, indices);
    }
}
