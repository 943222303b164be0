using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>Puts a scene together from a glTF file's nodes.</summary>
internal sealed class GltfScene
{
    private readonly GltfDocument _document;
    private readonly GltfNodes _nodes;
    private readonly GltfObjects _objects;
    private readonly GltfCameras _cameras;
    private readonly GltfLights _lights;
    private readonly List<(int Mesh, GltfObject Node, Transform World)> _meshes = [];
    private readonly List<(GltfObject Light, Transform World)> _lamps = [];
    private CameraDescription? _camera;
    private float? _aspectRatio;

    private GltfScene(GltfDocument document)
    {
        GltfFiles files = new(document);
        GltfBuffers buffers = new(document, files);
        GltfTextures textures = new(document, new GltfImages(document, buffers, files));
        _document = document;
        _nodes = new(document);
        _objects = new(document, new GltfMeshes(document, buffers), new GltfMaterials(document, textures));
        _cameras = new(document);
        _lights = new(document);
    }

    /// <summary>Reads everything that the file's scene shows.</summary>
    /// <exception cref="ModelException">Something is wrong with the file.</exception>
    public static ImportedModel Import(GltfDocument document)
    {
        GltfScene scene = new(document);
        foreach ((GltfObject node, Transform world) in scene._nodes.Walk())
        {
            scene.Visit(node, world);
        }

        scene.NoteWhatIsLeftOut();
        List<ShapeDescription> shapes = scene.Shapes();
        return new(
            new SceneDescription
            {
                Objects = scene._objects.Shared,
                Shapes = shapes,
                Lights = [.. scene._lamps.Select(l => scene._lights.Describe(l.Light, l.World)).OfType<ShapeDescription>()],
                Render = GltfCameras.PictureSize(scene._aspectRatio),
            },
            document.Notes.All)
        {
            Camera = scene._camera,
        };
    }

    private void Visit(GltfObject node, Transform world)
    {
        if (_document.Reference(node, "mesh", "meshes") is { } mesh)
        {
            _meshes.Add((mesh, node, world));
        }

        if (_lights.Find(node) is { } light)
        {
            _lamps.Add((light, world));
        }

        if (_cameras.Describe(node, world, out float? aspectRatio) is not { } camera)
        {
            return;
        }

        if (_camera is not null)
        {
            _document.Notes.Add("of several cameras, the first is used");
            return;
        }

        _camera = camera;
        _aspectRatio = aspectRatio;
    }

    private List<ShapeDescription> Shapes()
    {
        ILookup<int, int> uses = _meshes.ToLookup(m => m.Mesh, m => m.Mesh);
        List<ShapeDescription> shapes = [];
        foreach ((int mesh, GltfObject node, Transform world) in _meshes)
        {
            if (!world.IsInvertible || !Array.TrueForAll(Rows(world), float.IsFinite))
            {
                _document.Notes.Add("a mesh that is scaled to nothing, or too far away, is ignored");
                continue;
            }

            if (_objects.Place(mesh, uses[mesh].Count() > 1) is { } shape)
            {
                TransformDescription[] transform = world.IsIdentity ? [] : [new() { Matrix = Rows(world) }];
                shapes.Add(shape with { Name = node.Text("name") ?? shape.Name, Transform = transform });
            }
        }

        return shapes;
    }

    private static float[] Rows(Transform map) => [.. ((TransformRow[])[map.X, map.Y, map.Z]).SelectMany(r => (float[])[(float)r.A, (float)r.B, (float)r.C, (float)r.D])];

    private void NoteWhatIsLeftOut()
    {
        foreach ((string list, string what) in (ReadOnlySpan<(string, string)>)
            [("animations", "animations are ignored"), ("skins", "skins are ignored: meshes are shown as they were modelled")])
        {
            if (_document.List(list).Count > 0)
            {
                _document.Notes.Add(what);
            }
        }

        foreach (string name in _document.Root.Texts("extensionsUsed").Where(e => !GltfExtensions.All.Contains(e)).Distinct(StringComparer.Ordinal))
        {
            _document.Notes.Add($"the extension {Quotation.Of(name)} is unknown and ignored");
        }
    }
}
