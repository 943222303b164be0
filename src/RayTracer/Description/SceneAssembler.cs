using System.Numerics;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Description;

/// <summary>
/// Takes descriptions of shapes apart into what rays meet: transforms are worked into the numbers of triangles, and of other shapes where that
/// makes a shape of the same kind; what cannot be so placed, moves, or is shown as an instance, gets its own space.
/// </summary>
internal sealed class SceneAssembler(SceneBuilder builder)
{
    /// <summary>The largest number of instances in a scene.</summary>
    public const int MaximumInstances = 1 << 22;

    // Of how many widths from the origin a thing loses the shape that single precision gives it: some 1/500 of the width there.
    private const float MostDistances = 1 << 15;

    // Measured: a place, its motion and its share of the tree.
    private const int BytesPerInstance = 450;

    // In the tree, with its corners, in each place of a mesh.
    private const long BytesPerTriangle = 100;

    // The objects that instances show, by the material that they are shown in, or themselves where they keep theirs.
    private Dictionary<ShapeDescription, Dictionary<object, SpaceContents>> _objects = new(ReferenceEqualityComparer.Instance);
    private readonly MeshMender _mender = new(builder);

    // Whose meshes are being added; null outside of models.
    private ModelDescription? _model;
    private readonly HashSet<ImportedModel> _noted = new(ReferenceEqualityComparer.Instance);
    private readonly Dictionary<(Material Material, string Group), Material> _grouped = [];
    private LightGroupLabel? _label;
    private int _nesting;
    private bool _hasWarnedOfDistance;

    /// <summary>The world that some shapes make.</summary>
    public SpaceContents World { get; } = new();

    /// <summary>Adds a shape and all that it consists of.</summary>
    public void Add(ShapeDescription description) => Add(description, Motion.None, World);

    private void Add(ShapeDescription description, Motion outer, SpaceContents target)
    {
        LightGroupLabel? before = _label;
        _label = LightGroupLabel.Of(description, before);
        AddPlaced(description, outer, target);
        _label = before;
    }

    private void AddPlaced(ShapeDescription description, Motion outer, SpaceContents target)
    {
        Motion motion = outer * TransformSteps.Motion(description, description.Transform, description.Motion, builder);
        if (motion.IsStill)
        {
            AddStill(description, motion.At(0), target);
            return;
        }

        SpaceContents own = new();
        AddStill(description, Transform.Identity, own);
        AddInstance(description, own, motion, target);
    }

    private void AddStill(ShapeDescription description, in Transform place, SpaceContents target)
    {
        // Objects of objects, and models of models that a program made, could go round in a circle.
        if (++_nesting > 200)
        {
            builder.Error(description, null, "records are nested too deep");
        }
        else
        {
            switch (description)
            {
                case GroupDescription group:
                    AddAll(group, group.Shapes, place, target);
                    break;
                case InstanceDescription instance:
                    AddObject(instance, place, target);
                    break;
                case MeshDescription mesh:
                    AddMesh(mesh, place, target);
                    break;
                case ModelDescription model:
                    AddModel(model, place, target);
                    break;
                case PunctualLightDescription light:
                    AddLight(light, place, target);
                    break;
                default:
                    AddShape(description, place, target);
                    break;
            }
        }

        _nesting--;
    }

    private void AddAll(ShapeDescription parent, IEnumerable<ShapeDescription> shapes, in Transform place, SpaceContents target)
    {
        Motion still = Motion.Still(place);
        using (builder.Inherit(parent.Material))
        {
            foreach (ShapeDescription shape in shapes)
            {
                Add(shape, still, target);
            }
        }
    }

    private void AddObject(InstanceDescription instance, in Transform place, SpaceContents target)
    {
        if (instance.Of is null)
        {
            builder.Error(instance, nameof(InstanceDescription.Of), "an instance needs a shape to show");
            return;
        }

        AddInstance(instance, Object(instance, instance.Of), Motion.Still(place), target);
    }

    private SpaceContents Object(InstanceDescription instance, ShapeDescription of)
    {
        MaterialDescription? material = builder.ReplacementBy(instance.Material);
        object key = (object?)material ?? of;
        if (!_objects.TryGetValue(of, out Dictionary<object, SpaceContents>? copies))
        {
            copies = new(ReferenceEqualityComparer.Instance);
            _objects.Add(of, copies);
        }

        if (!copies.TryGetValue(key, out SpaceContents? contents))
        {
            contents = new() { Name = builder.NameOf(of) };
            LightGroupLabel? label = _label;
            _label = null;
            using (builder.InheritNothing(material))
            {
                Add(of, Motion.None, contents);
            }

            _label = label;
            copies.Add(key, contents);
        }

        return contents;
    }

    private void AddInstance(ShapeDescription subject, SpaceContents contents, Motion motion, SpaceContents target)
    {
        if ((long)contents.Instances.Count + target.Instances.Count + contents.Lights.Count + target.Lights.Count >= MaximumInstances)
        {
            Refuse(subject, $"nested instances come to more than {MaximumInstances}");
            return;
        }

        long instances = 1L + contents.Instances.Count;
        if (builder.Budget.Take($"{instances} more instances", BytesPerInstance * instances, SceneBudget.StepsPerInstance * instances) is { } complaint)
        {
            Refuse(subject, complaint);
            return;
        }

        ShapeDescription? source = builder.SourceOf(subject);
        (double open, double close) = builder.Shutter;
        if (!motion.IsInvertible(open, close))
        {
            builder.Error(subject, nameof(ShapeDescription.Transform), "the combined transforms have numbers too large or too small to compute with");
            return;
        }

        if (contents.HasSurfaces)
        {
            target.Instances.Add(new(contents, motion, source, _label));
        }

        foreach (PlacedSpace inner in contents.Instances.ToArray())
        {
            target.Instances.Add(new(inner.Contents, motion * inner.Motion, source, LightGroupLabel.Within(inner.Label, _label)));
        }

        foreach (PlacedLight inner in contents.Lights.ToArray())
        {
            target.Lights.Add(inner with { Motion = motion * inner.Motion, Label = LightGroupLabel.Within(inner.Label, _label) });
        }
    }

    // Once: whatever holds this one does not fit either.
    private void Refuse(ShapeDescription subject, string complaint)
    {
        if (!builder.HasErrors)
        {
            builder.Error(subject, null, complaint);
        }
    }

    // Once: what is wrong with one is wrong with all that lie there.
    private void WarnOfDistance(ShapeDescription subject, in Bounds bounds)
    {
        Vector3 size = bounds.Maximum - bounds.Minimum;
        float far = Vector3.Max(Vector3.Abs(bounds.Minimum), Vector3.Abs(bounds.Maximum)).Largest();
        if (!_hasWarnedOfDistance && bounds.IsFinite && size.Largest() * MostDistances < far)
        {
            _hasWarnedOfDistance = true;
            string place = FormattableString.Invariant($"{size.Largest():g3} wide and lies at {far:g3}");
            string step = FormattableString.Invariant($"{float.BitIncrement(far) - far:g2}");
            builder.Warn(subject, null, $"this {RecordType.Of(subject.GetType()).Name} is {place}, where single-precision numbers are {step} apart: its shape, "
                + "light and shadow are coarse. Describe it near the origin, and place it by an instance");
        }
    }

    private void AddLight(PunctualLightDescription light, in Transform place, SpaceContents target)
    {
        int before = builder.Complaints.Count;
        light.Check(place, builder);
        if (builder.Complaints.Count == before)
        {
            target.Lights.Add(new(light, Motion.Still(place), _label, light.BuildPicture(builder)));
        }
    }

    private void AddShape(ShapeDescription description, in Transform place, SpaceContents target)
    {
        Shape? shape = description.Build(builder);
        if (shape is null)
        {
            return;
        }

        if (shape.Material.Traits.Emits && !float.IsFinite(shape.Area) && !builder.HasErrors)
        {
            builder.Error(description, null, "the area of this light is too large a number to compute with");
        }

        if (shape.Bounds.IsFinite && !shape.Bounds.Transformed(place).IsFinite)
        {
            builder.Error(description, nameof(ShapeDescription.Transform), "the transform moves the shape to numbers too large to compute with");
            return;
        }

        if (!shape.Material.Traits.Emits)
        {
            WarnOfDistance(description, shape.Bounds.Transformed(place));
        }

        shape.Source = builder.SourceOf(description);
        shape.Label = _label;
        if (place.IsIdentity)
        {
            target.Shapes.Add(shape);
        }
        else if (!NeedsOwnSpace(shape) && shape.Transformed(place) is { } moved)
        {
            moved.Source = shape.Source;
            moved.Label = shape.Label;
            target.Shapes.Add(moved);
        }
        else
        {
            SpaceContents own = new();
            own.Shapes.Add(shape);
            AddInstance(description, own, Motion.Still(place), target);
        }
    }

    // Textures in space go with the shape.
    private static bool NeedsOwnSpace(Shape shape) => shape.Bounds.IsFinite && DependsOnPlace(shape.Material);

    private static bool DependsOnPlace(Material material) => (material.Inputs & TextureInputs.ObjectPoint) != TextureInputs.None;

    private void AddMesh(MeshDescription mesh, in Transform place, SpaceContents target)
    {
        if (mesh.File.Length > 0)
        {
            if (builder.Model(mesh, nameof(MeshDescription.File), mesh.File) is { } model)
            {
                using (builder.Within(mesh, nameof(MeshDescription.File)))
                using (builder.Replace(mesh.Material))
                {
                    int parts = 0;
                    AddMeshesOf(mesh, model.Scene.Shapes, Motion.Still(place), target, ref parts);
                    if (mesh.Part >= parts)
                    {
                        builder.Error(mesh, nameof(MeshDescription.Part), $"there is no mesh {mesh.Part} in \"{mesh.File}\": it has {parts}, counted from 0");
                    }
                }
            }

            return;
        }

        AddTriangles(_model is null ? mesh : AsWanted(mesh, _model), mesh, place, target);
    }

    private static MeshDescription AsWanted(MeshDescription mesh, ModelDescription model) => mesh with
    {
        Shading = model.Smooth && mesh.Shading == MeshShading.Own ? MeshShading.Smooth : mesh.Shading,
        Refinement = model.Refinement,
    };

    // Only the triangles of a file, made of what the mesh says.
    private void AddMeshesOf(MeshDescription parent, IEnumerable<ShapeDescription> shapes, Motion outer, SpaceContents target, ref int parts)
    {
        foreach (ShapeDescription shape in shapes)
        {
            Motion place = outer * TransformSteps.Motion(shape, shape.Transform, shape.Motion, builder);
            switch (shape)
            {
                case MeshDescription when parent.Part >= 0 && parent.Part != parts++:
                    break;
                case MeshDescription mesh:
                    AddTriangles(parent, mesh, place.At(builder.Shutter.Open), target);
                    break;
                case GroupDescription group:
                    AddMeshesOf(parent, group.Shapes, place, target, ref parts);
                    break;
                case InstanceDescription { Of: { } of }:
                    AddMeshesOf(parent, [of], place, target, ref parts);
                    break;
            }
        }
    }

    private void AddTriangles(MeshDescription wanted, MeshDescription mesh, in Transform place, SpaceContents target)
    {
        IReadOnlyList<MaterialDescription> described = wanted.Materials.Count > 0 ? wanted.Materials : [wanted.Material];
        Material[] materials = [.. described.Select(builder.SurfaceMaterial)];
        MeshData? data = _mender.Mended(wanted, mesh);
        if (data is null || data.TriangleCount == 0)
        {
            return;
        }

        if (builder.Budget.Take($"{data.TriangleCount} more triangles", BytesPerTriangle * data.TriangleCount, SceneBudget.StepsPerTriangle * data.TriangleCount) is { } complaint)
        {
            Refuse(mesh, complaint);
            return;
        }

        if (!MeshTable.BoundsOf(data).Transformed(place).IsFinite)
        {
            builder.Error(mesh, nameof(ShapeDescription.Transform), "the transform moves the mesh to numbers too large to compute with");
            return;
        }

        WarnOfDistance(mesh, MeshTable.BoundsOf(data).Transformed(place));
        if (data.Uv is null && materials.Any(m => m.Traits.UsesUv && (m.Inputs & TextureInputs.Uv) != TextureInputs.None))
        {
            builder.Warn(mesh, null, $"{MeshMender.Name(mesh)} has no uv, so its texture shows the colour at (0, 0) everywhere");
        }

        materials = [.. materials.Select(InLightGroup)];
        if (!place.IsIdentity && materials.Any(DependsOnPlace))
        {
            SpaceContents own = new();
            own.Meshes.Add(new(data, materials, Transform.Identity, builder.SourceOf(mesh), _label));
            AddInstance(mesh, own, Motion.Still(place), target);
            return;
        }

        target.Meshes.Add(new(data, materials, place, builder.SourceOf(mesh), _label));
    }

    // Triangles of one luminaire are one source: those of another light group get their own.
    private Material InLightGroup(Material material)
    {
        if (material is not LuminaireMaterial luminaire || _label?.Group is not { } group)
        {
            return material;
        }

        if (!_grouped.TryGetValue((material, group), out Material? own))
        {
            own = luminaire.Copy();
            _grouped.Add((material, group), own);
        }

        return own;
    }

    private void AddModel(ModelDescription model, in Transform place, SpaceContents target)
    {
        if (builder.Model(model, nameof(ModelDescription.File), model.File) is not { } imported)
        {
            return;
        }

        if (_noted.Add(imported))
        {
            foreach (string note in imported.Notes)
            {
                builder.Warn(model, nameof(ModelDescription.File), $"\"{model.File}\": {note}");
            }
        }

        SceneDescription scene = ModelPlayback.Of(model, imported, builder);
        builder.TakeNames(scene);
        (ModelDescription? outer, Dictionary<ShapeDescription, Dictionary<object, SpaceContents>> objects) = (_model, _objects);
        _model = model;
        if (model.Smooth || model.Refinement.MovesCorners)
        {
            // Its objects are other ones than where the same file is shown as it is.
            _objects = new(ReferenceEqualityComparer.Instance);
        }

        using (builder.Within(model, nameof(ModelDescription.File)))
        using (builder.InheritNothing(builder.ReplacementBy(model.Material)))
        {
            Motion still = Motion.Still(place);
            foreach (ShapeDescription shape in scene.Shapes.Concat(scene.Lights))
            {
                Add(shape, still, target);
            }
        }

        (_model, _objects) = (outer, objects);
    }
}
