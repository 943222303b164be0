using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>Puts a scene together from a glTF file's nodes.</summary>
internal sealed class GltfScene
{
    private readonly GltfDocument _document;
    private readonly GltfNodes _nodes;
    private readonly IReadOnlyList<GltfClip> _clips;
    private readonly GltfSkins _skins;
    private readonly GltfInstances _instances;
    private readonly GltfObjects _objects;
    private readonly GltfCameras _cameras;
    private readonly GltfLights _lights;
    private readonly HashSet<int> _repeated;

    private GltfScene(GltfDocument document)
    {
        GltfFiles files = new(document);
        GltfBuffers buffers = new(document, files);
        GltfAccessors accessors = new(document, buffers);
        GltfTextures textures = new(document, new GltfImages(document, buffers, files));
        _document = document;
        _nodes = new(document);
        _clips = new GltfClips(document, accessors).Read();
        _skins = new(document, accessors, _nodes);
        _instances = new(document, accessors);
        _objects = new(document, new GltfMeshes(document, accessors), new GltfMaterials(document, textures));
        _cameras = new(document);
        _lights = new(document);
        _repeated = [.. _nodes.Shown.Select(MeshOf).OfType<int>().GroupBy(m => m).Where(g => g.Count() > 1).Select(g => g.Key)];
    }

    /// <summary>Reads everything that the file's scene shows.</summary>
    /// <exception cref="ModelException">Something is wrong with the file.</exception>
    public static ImportedModel Import(GltfDocument document)
    {
        GltfScene scene = new(document);
        SceneDescription atFirst = scene.At(new(0, null, 0, 0, time => time));
        CameraDescription? camera = scene.Camera(out float? aspectRatio);
        string[] variants = [.. document.Root.Extension("KHR_materials_variants")?.Children("variants").Select(v => v.Text("name") ?? "") ?? []];
        document.Notes.AddIf(variants.Length > 0, $"of the variants of materials ({string.Join(", ", variants.Take(10).Select(Quotation.Of))}), \"variant\" chooses one; without it the file's own are shown");
        scene.NoteWhatIsLeftOut();
        return new(atFirst with { Objects = scene._objects.Shared, Render = GltfCameras.PictureSize(aspectRatio) }, document.Notes.All)
        {
            Camera = camera,
            Animations = [.. scene._clips.Select(c => c.Model)],
            Variants = variants,
            At = scene._clips.Count + variants.Length > 0 ? scene.At : null,
        };
    }

    // Buffers and pictures stay, so that frames of an animation need not read them again.
    private SceneDescription At(ModelMoment moment)
    {
        GltfPose pose = new(_nodes, _clips.Count > 0 ? _clips[moment.Animation] : null, moment);
        return new()
        {
            Shapes = [.. _nodes.Shown.SelectMany(n => Shapes(n, pose, moment.Variant))],
            Lights = [.. _nodes.Shown.Select(n => Light(n, pose)).OfType<ShapeDescription>()],
        };
    }

    private int? MeshOf(int node) => _document.Reference(_document.List("nodes")[node], "mesh", "meshes");

    private IEnumerable<ShapeDescription> Shapes(int index, GltfPose pose, int? variant)
    {
        if (MeshOf(index) is not { } mesh)
        {
            return [];
        }

        GltfObject node = _document.List("nodes")[index];
        IReadOnlyList<Transform>? places = _instances.Of(node);
        GltfDeformation? deformation = Deformation(node, index, mesh, pose);
        if ((deformation is null ? _objects.Place(mesh, _repeated.Contains(mesh) || places is { Count: > 1 }, variant) : _objects.Bent(mesh, deformation, variant)) is not { } shape)
        {
            return [];
        }

        shape = shape with { Name = node.Text("name") ?? shape.Name };
        if (deformation?.Joints is not null)
        {
            return [shape];
        }

        ShapeDescription?[] put = [.. (places ?? [Transform.Identity]).Select(p => pose.Put(shape, index, p))];
        _document.Notes.AddIf(put.Contains(null), "a mesh that is scaled to nothing, or too far away, is ignored");
        return put.OfType<ShapeDescription>();
    }

    // The joints of a skin put it into the world: the place of its own node does not count.
    private GltfDeformation? Deformation(GltfObject node, int index, int mesh, GltfPose pose)
    {
        IReadOnlyList<float> weights = pose.Weights(index) ?? Weights(node) ?? Weights(_document.List("meshes")[mesh]) ?? [];
        Transform[]? joints = _document.Reference(node, "skin", "skins") is { } skin ? _skins.Joints(skin, pose.Middle) : null;
        return joints is null && weights.All(w => w == 0) ? null : new(weights, joints);
    }

    private static float[]? Weights(GltfObject owner) => owner.Numbers("weights");

    private ShapeDescription? Light(int index, GltfPose pose)
    {
        if (_lights.Find(_document.List("nodes")[index]) is not { } light)
        {
            return null;
        }

        return pose.Keyframes(index) is { } keyframes && _lights.Describe(light, Transform.Identity) is { } still
            ? still with { Motion = keyframes }
            : _lights.Describe(light, pose.Middle[index]);
    }

    private CameraDescription? Camera(out float? aspectRatio)
    {
        Transform[] worlds = _nodes.Worlds(_clips.Count > 0 ? _clips[0] : null, 0);
        CameraDescription? found = null;
        aspectRatio = null;
        foreach (int index in _nodes.Shown)
        {
            GltfObject node = _document.List("nodes")[index];
            if (_cameras.Describe(node, worlds[index], out float? itsRatio) is not { } camera)
            {
                continue;
            }

            _document.Notes.AddIf(found is not null, "of several cameras, the first is used");
            if (found is null)
            {
                found = _clips.Count > 0 && _cameras.Describe(node, Transform.Identity, out _) is { } still ? GltfCameras.Moving(still, _nodes, _clips[0], index) ?? camera : camera;
                aspectRatio = itsRatio;
            }
        }

        return found;
    }

    private void NoteWhatIsLeftOut()
    {
        foreach (string name in _document.Root.Texts("extensionsUsed").Where(e => !GltfExtensions.All.Contains(e)).Distinct(StringComparer.Ordinal))
        {
            _document.Notes.Add($"the extension {Quotation.Of(name)} is unknown and ignored");
        }
    }
}
