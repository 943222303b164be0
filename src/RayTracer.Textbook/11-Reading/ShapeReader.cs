using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Shapes;

namespace RayTracer.Textbook;

/// <summary>Takes descriptions of shapes apart into things: groups, instances and models are gone then, each thing stands where it belongs.</summary>
/// <param name="refusals">Takes what there is none of.</param>
/// <param name="materials">Makes the materials.</param>
/// <param name="loadModel">Reads the model file of a path.</param>
internal sealed class ShapeReader(Refusals refusals, MaterialReader materials, Func<string, ImportedModel> loadModel)
{
    private const string Known = "sphere, plane, disk, rectangle, triangle, mesh, box, torus, model, group and instance, and point lights";
    private readonly Dictionary<object, List<(Mesh Mesh, int Material)>> _meshes = new(ReferenceEqualityComparer.Instance);

    /// <summary>All things so far.</summary>
    public List<Thing> Things { get; } = [];

    /// <summary>All lights without extent so far.</summary>
    public List<ILight> Points { get; } = [];

    /// <summary>Adds a shape and all that it consists of.</summary>
    /// <param name="shape">The shape.</param>
    public void Add(ShapeDescription shape) => Add(shape, Transform.Identity, new(ShapeDescription.DefaultMaterial, null));

    /// <summary>The map of some steps, the first one applied first; in each the matrix first, then scale, rotation and translation.</summary>
    public static Transform Place(IReadOnlyList<TransformDescription> steps)
    {
        Transform all = Transform.Identity;
        foreach (TransformDescription step in steps)
        {
            IReadOnlyList<float> m = step.Matrix;
            Transform matrix = m.Count == 0 ? Transform.Identity : new(new(m[0], m[4], m[8]), new(m[1], m[5], m[9]), new(m[2], m[6], m[10]), new(m[3], m[7], m[11]));
            Transform turn = step.Rotate == 0 ? Transform.Identity : Transform.Rotation(step.Axis, step.Rotate);
            all = Transform.Translation(step.Translate).After(turn).After(Transform.Scaling(step.Scale)).After(matrix).After(all);
        }

        return all;
    }

    private void Add(ShapeDescription shape, Transform outer, Surrounding around)
    {
        if (shape.Motion.Count > 0)
        {
            refusals.Say(shape, nameof(shape.Motion), "the textbook edition has no \"motion\": everything stands still in it");
        }

        Transform place = outer.After(Place(shape.Transform));
        MaterialDescription material = around.Of(shape.Material);
        switch (shape)
        {
            case GroupDescription group:
                AddAll(group.Shapes, place, around with { Inherited = around.Replacing is null ? material : around.Inherited });
                break;
            case InstanceDescription { Of: { } of } instance:
                Add(of, place, around.Within(instance.Material));
                break;
            case ModelDescription model when Load(model, nameof(model.File), model.File) is { } imported:
                if (imported.Animations.Count > 0)
                {
                    refusals.Say(model, nameof(model.File), "the textbook edition does not move models, and this one has animations");
                }

                refusals.Rest(model, nameof(model.File), nameof(model.Material), nameof(model.Transform));
                AddAll([.. imported.Scene.Shapes, .. imported.Scene.Lights], place, around.Within(model.Material));
                break;
            case ModelDescription:
                break;
            case MeshDescription mesh:
                AddMesh(mesh, place, material);
                break;
            case PointLightDescription light:
                refusals.Rest(light, nameof(light.Position), nameof(light.Intensity), nameof(light.Transform), nameof(light.Motion));
                Points.Add(new PointLight(place.Point(light.Position), light.Intensity));
                break;
            case var _ when Shape(shape) is { } own:
                AddThing(own, place, material, shape);
                break;
        }
    }

    private void AddAll(IEnumerable<ShapeDescription> shapes, Transform place, Surrounding around)
    {
        foreach (ShapeDescription shape in shapes)
        {
            Add(shape, place, around);
        }
    }

    private void AddThing(IShape shape, Transform place, MaterialDescription material, ShapeDescription source)
    {
        IShape placed = place == Transform.Identity ? shape : new Placed(shape, place);
        AreaLight? light = materials.Luminaire(material) is { } luminaire ? new(placed, luminaire) : null;
        Things.Add(new(placed, materials.Material(material), light, source));
    }

    private IShape? Shape(ShapeDescription shape) => shape switch
    {
        SphereDescription s => new Sphere(s.Center, s.Radius),
        PlaneDescription { Size: { } size } p => Around(p.Point, p.Normal, size.X, size.Y, (corner, right, up) => new Rectangle(corner, right, up)),
        PlaneDescription p when Box.Sides(((Vector)p.Normal).Unit) is var (right, up) => new Plane(p.Point, right, up),
        DiskDescription d => Around(d.Center, d.Normal, 2 * d.Radius, 2 * d.Radius, (corner, right, up) => new Disk(corner, right, up)),
        RectangleDescription r => new Rectangle(r.Corner, r.EdgeU, r.EdgeV),
        TriangleDescription t => new Triangle(t.A, t.B, t.C, (new(t.UvA.X, t.UvA.Y, 0), new(t.UvB.X, t.UvB.Y, 0), new(t.UvC.X, t.UvC.Y, 0))),
        BoxDescription b => new Box(Bounds.Around(b.A, b.B)),
        TorusDescription t => new Placed(new Torus(t.Radius, t.TubeRadius), Upright(t.Center, ((Vector)t.Axis).Unit)),
        IOwnShape own => own.Make(),
        PunctualLightDescription => (IShape?)refusals.Type(shape, "light", "point lights, luminaires and environments"),
        _ => (IShape?)refusals.Type(shape, "shape", Known),
    };

    // Something flat around a point, by its corner and its sides.
    private static IShape Around(Vector middle, Vector normal, double width, double height, Func<Vector, Vector, Vector, IShape> make)
    {
        (Vector right, Vector up) = Box.Sides(normal.Unit);
        (right, up) = (right * width, up * height);
        return make(middle - (0.5 * (right + up)), right, up);
    }

    // From around the y axis to around another, so that pictures that are wrapped around still face +z where that is level.
    private static Transform Upright(Vector center, Vector axis)
    {
        Vector across = Vector.Cross(axis, new(0, 0, 1));
        Vector right = across.Length > 1e-6 ? across.Unit : new(1, 0, 0);
        return new(right, axis, Vector.Cross(right, axis), center);
    }

    private void AddMesh(MeshDescription mesh, Transform place, MaterialDescription material)
    {
        refusals.Rest(
            mesh, nameof(mesh.File), nameof(mesh.Positions), nameof(mesh.Triangles), nameof(mesh.Normals), nameof(mesh.Uv), nameof(mesh.Materials), nameof(mesh.Material),
            nameof(mesh.MaterialOfTriangle), nameof(mesh.Part), nameof(mesh.Shading), nameof(mesh.FlipNormals), nameof(mesh.FlipV), nameof(mesh.IgnoreColors),
            nameof(mesh.Transform), nameof(mesh.Motion));
        if (mesh.File.Length == 0)
        {
            AddParts(mesh, mesh, place, material);
        }
        else if (Load(mesh, nameof(mesh.File), mesh.File) is { } model)
        {
            int part = 0;
            AddMeshesOf(mesh, model.Scene.Shapes, place, material, ref part);
        }
    }

    // Only the triangles of a file, made of what the mesh says.
    private void AddMeshesOf(MeshDescription wanted, IEnumerable<ShapeDescription> shapes, Transform outer, MaterialDescription material, ref int part)
    {
        foreach (ShapeDescription shape in shapes)
        {
            Transform place = outer.After(Place(shape.Transform));
            switch (shape)
            {
                case MeshDescription when wanted.Part >= 0 && wanted.Part != part++:
                    break;
                case MeshDescription mesh:
                    AddParts(wanted, mesh, place, material);
                    break;
                case GroupDescription group:
                    AddMeshesOf(wanted, group.Shapes, place, material, ref part);
                    break;
                case InstanceDescription { Of: { } of }:
                    AddMeshesOf(wanted, [of], place, material, ref part);
                    break;
            }
        }
    }

    private void AddParts(MeshDescription wanted, MeshDescription mesh, Transform place, MaterialDescription material)
    {
        // What one file's mesh becomes in one shape is not kept for others.
        object key = ReferenceEquals(wanted, mesh) ? (object?)mesh.Data ?? mesh : wanted;
        if (!_meshes.TryGetValue(key, out List<(Mesh, int)>? parts) || !ReferenceEquals(wanted, mesh))
        {
            parts = MeshReader.Read(wanted, mesh, refusals);
            _meshes[key] = parts;
        }

        foreach ((Mesh part, int number) in parts)
        {
            AddThing(part, place, wanted.Materials.Count > 0 ? wanted.Materials[number] : material, wanted);
        }
    }

    private ImportedModel? Load(object subject, string property, string file)
    {
        try
        {
            return loadModel(file);
        }
        catch (ModelException e)
        {
            refusals.Say(subject, property, e.Message);
            return null;
        }
    }

    // The material of shapes that give none, and that of all shapes whatever they give.
    private sealed record Surrounding(MaterialDescription Inherited, MaterialDescription? Replacing)
    {
        public MaterialDescription Of(MaterialDescription own) => Replacing ?? (IsNone(own) ? Inherited : own);

        // What instances and models show inherits nothing, and is replaced where they have a material.
        public Surrounding Within(MaterialDescription own) => new(ShapeDescription.DefaultMaterial, Replacing ?? (IsNone(own) ? null : own));

        private static bool IsNone(MaterialDescription material) => ReferenceEquals(material, ShapeDescription.DefaultMaterial);
    }
}
