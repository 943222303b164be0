using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Lights;

/// <summary>Finds what shines in a scene.</summary>
internal static class LightList
{
    /// <summary>All sources: shapes of the world, its meshes, those that instances show, and then those without extent.</summary>
    public static LightSource[] Create(World world)
    {
        List<LightSource> lights = [];
        AddShapes(lights, world.Itself, (shape, batch, i) => new AreaLight(shape, i) { Table = batch, Label = shape.Label });
        AddMeshes(lights, world.Itself, world.Itself.Contents, null, 0, Transform.Identity);
        for (int instance = 1; instance <= (world.Instances?.Count ?? 0); instance++)
        {
            AddInstance(lights, world.Instances!, instance);
        }

        lights.AddRange(world.Itself.Contents.Lights.Select(Punctual));
        lights.ForEach(l => l.World = world);
        return [.. lights];
    }

    private static void AddShapes(List<LightSource> lights, Space space, Func<Shape, ShapeBatch, int, LightSource> make)
    {
        foreach (ShapeBatch batch in space.Batches)
        {
            for (int primitive = batch.FirstPrimitive; primitive < batch.FirstPrimitive + batch.Count; primitive++)
            {
                Shape shape = space.Shapes[primitive - space.FirstPrimitive];
                if (shape.Material.Traits.Emits)
                {
                    lights.Add(make(shape, batch, primitive));
                }
            }
        }
    }

    private static unsafe void AddInstance(List<LightSource> lights, InstanceTable instances, int instance)
    {
        Space space = instances.SpaceOf(instance);
        if (!space.Shines)
        {
            return;
        }

        AddShapes(lights, space, (shape, batch, i) =>
            new InstancedLight(shape, batch, i, instances, instance) { Label = LightGroupLabel.Within(shape.Label, instances.LabelOf(instance)) });
        AddMeshes(lights, space, space.Contents, instances, instance, instances.PlaceOf(instance));
    }

    // One source for the triangles of each luminaire. Their areas are those at the place where the shutter opens.
    private static void AddMeshes(List<LightSource> lights, Space space, SpaceContents contents, InstanceTable? instances, int instance, Transform place)
    {
        if (space.Mesh is not { } mesh || !contents.Meshes.Exists(m => m.Materials.Any(material => material.Traits.Emits)))
        {
            return;
        }

        foreach (IGrouping<Material, int> triangles in space.MaterialOfTriangle.Select((material, i) => (material, i)).Where(t => t.material.Traits.Emits).GroupBy(t => t.material, t => t.i))
        {
            TriangleChoice choice = new([.. triangles], t => Area(mesh, t, place));
            if (choice.IsFinite)
            {
                lights.Add(new MeshLight(mesh, (LuminaireMaterial)triangles.Key, choice, instances, instance)
                {
                    Label = LightGroupLabel.Within(LabelOf(contents, triangles.Key), instances?.LabelOf(instance)),
                });
            }
        }
    }

    private static LightSource Punctual(PlacedLight placed)
    {
        LightSource light = placed.Light.Create(placed.Motion, placed.Picture);
        light.Label = placed.Label;
        return light;
    }

    // What all meshes say that have some of the luminaire.
    private static LightGroupLabel? LabelOf(SpaceContents contents, Material luminaire)
    {
        LightGroupLabel?[] labels = [.. contents.Meshes.Where(m => m.Materials.Contains(luminaire)).Select(m => m.Label).Distinct()];
        return labels is [var only] ? only : labels.Select(l => l?.Group).Distinct().ToArray() is [{ } group] ? new(group, null) : null;
    }

    private static double Area(MeshTable mesh, int triangle, in Transform place)
    {
        (Vector3 a, Vector3 b, Vector3 c) = mesh.Corners(triangle);
        return 0.5 * place.Vector(b - a).Cross(place.Vector(c - a)).Norm();
    }
}
