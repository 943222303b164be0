using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>Makes shapes: which they are, what they are made of, and whether they shine.</summary>
internal sealed class MitsubaShapes(MitsubaReading reading, MitsubaBsdfs bsdfs, MitsubaEmitters emitters)
{
    private static readonly string[] s_types =
        ["rectangle", "sphere", "disk", "cylinder", "cube", "obj", "ply", "serialized", "shapegroup", "instance", "merge"];

    private readonly Dictionary<MitsubaObject, ShapeDescription> _groups = [];

    /// <summary>The groups that instances show, by their names.</summary>
    public Dictionary<string, ShapeDescription> Groups { get; } = new(StringComparer.Ordinal);

    /// <summary>The shape that a thing is; null where nothing of it is seen by itself, or after an error.</summary>
    public ShapeDescription? Read(MitsubaObject shape)
    {
        ShapeDescription? made = shape.Type switch
        {
            "shapegroup" => Group(shape),
            "instance" => Instance(shape),
            "merge" => new GroupDescription { Shapes = [.. shape.Children("shape").Select(Read).OfType<ShapeDescription>()] },
            _ => Surface(shape),
        };
        shape.Finish();
        return made is null || shape.Type == "shapegroup" ? null : reading.At(shape.Place, made with { Name = shape.Id });
    }

    private ShapeDescription? Group(MitsubaObject shape)
    {
        if (!_groups.TryGetValue(shape, out ShapeDescription? group))
        {
            foreach (MitsubaObject nested in shape.Children("shape").Where(IsGrouped))
            {
                reading.Log.Error(nested.Place, $"a shapegroup cannot hold {(nested.Type == "instance" ? "an instance" : "another one")}");
            }

            group = reading.At(shape.Place, new GroupDescription { Name = shape.Id, Shapes = [.. shape.Children("shape").Where(s => !IsGrouped(s)).Select(Read).OfType<ShapeDescription>()] });
            _groups.Add(shape, group);
            Groups[shape.Id.Length > 0 ? shape.Id : $"group {Groups.Count + 1}"] = group;
        }

        return group;
    }

    private static bool IsGrouped(MitsubaObject shape) => shape.Type is "shapegroup" or "instance";

    private InstanceDescription? Instance(MitsubaObject shape)
    {
        Transform place = shape.Transform();
        if (shape.Only("shape") is not { Type: "shapegroup" } group)
        {
            if (!shape.LacksSomething)
            {
                reading.Log.Error(shape.Place, "an instance needs a shapegroup to show");
            }

            return null;
        }

        ShapeDescription? of = Group(group);
        group.Finish();
        return new() { Of = of, Transform = MitsubaSurfaces.Steps(place) };
    }

    private ShapeDescription? Surface(MitsubaObject shape)
    {
        if (!s_types.Contains(shape.Type))
        {
            reading.Log.Unknown(shape.TypePlace, $"shapes of type {Quotation.Of(shape.Type)} are not supported", shape.Type, s_types);
            return null;
        }

        MaterialDescription material = Material(shape);
        return shape.Type is "obj" or "ply" or "serialized" ? MitsubaMeshes.Read(shape, material) : MitsubaSurfaces.Read(shape, material);
    }

    private MaterialDescription Material(MitsubaObject shape)
    {
        MitsubaObject? emitter = shape.Only("emitter");
        MaterialDescription material = shape.Only("bsdf") is { } bsdf ? bsdfs.Read(bsdf) : emitter is null ? MitsubaBsdfs.Standard : MitsubaBsdfs.Black;
        MaterialDescription filled = MitsubaMedia.Fill(shape, material);
        return emitter is null ? filled : emitters.Area(emitter, filled);
    }
}
