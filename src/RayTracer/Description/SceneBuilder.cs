using System.Numerics;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Description;

/// <summary>
/// Turns a <see cref="SceneDescription"/> into a renderable <see cref="Scene"/>. Every complaint is collected, none is
/// thrown, so that a scene's author sees all of them at once.
/// </summary>
/// <param name="loadPicture">
/// Loads the picture file of the given path (first argument, as in the scene file), decoded from sRGB unless the second
/// argument says that its numbers are to be taken raw. May throw <see cref="PictureException"/>. Without it, no picture can be read.
/// </param>
/// <param name="loadModel">
/// Loads the model file of the given path, as in the scene file. May throw <see cref="ModelException"/>. Without it, no model can be read.
/// </param>
/// <param name="loadGrid">Loads the grid that a record names. May throw <see cref="VolumeException"/>. Without it, no grid can be read.</param>
public sealed class SceneBuilder(
    Func<string, bool, Picture>? loadPicture = null, Func<string, ImportedModel>? loadModel = null, Func<GridDescription, VolumeGrid>? loadGrid = null)
{
    private readonly Dictionary<object, object> _built = new(ReferenceEqualityComparer.Instance);
    private readonly Dictionary<object, object> _numberTextures = new(ReferenceEqualityComparer.Instance);
    private readonly Dictionary<MediumDescription, Medium?> _media = new(ReferenceEqualityComparer.Instance);
    private readonly Dictionary<object, string> _names = new(ReferenceEqualityComparer.Instance);
    private readonly List<SceneComplaint> _complaints = [];
    private RangeCheck? _ranges;
    private MaterialDescription _inherited = ShapeDescription.DefaultMaterial;
    private MaterialDescription? _replacement;
    private (object Subject, string Property)? _source;

    // What the textures depend on that the material under way has asked for.
    private TextureInputs _inputs;

    // How many textures the one that is being built consists of, and those that were.
    private const int MostTextures = 1024;
    private readonly Dictionary<Texture, int> _texturesIn = new(ReferenceEqualityComparer.Instance);
    private int _textures;

    // How many materials are being built, the inner ones of others among them.
    private int _parts;

    /// <summary>The sampling of spheres that shine.</summary>
    public SphereLightSampling SphereLightSampling { get; private set; }

    /// <summary>All complaints so far, in the order in which they came up.</summary>
    public IReadOnlyList<SceneComplaint> Complaints => _complaints;

    /// <summary>True where any complaint is an error.</summary>
    public bool HasErrors => _complaints.Exists(c => c.IsError);

    /// <summary>
    /// True where the scene keeps the records that its parts were made from, for editors; they then live as long as it does.
    /// </summary>
    public bool KeepsSources { get; init; }

    /// <summary>The animations of models that are played, by the file and the animation's name in the scene, with the seconds that each takes.</summary>
    internal Dictionary<(string File, string Animation), double> Played { get; } = [];

    /// <summary>The memory that the scene's files and instances may take.</summary>
    public SceneBudget Budget { get; init; } = new();

    /// <summary>Reports an error about a record's property (by its C# name; null means the whole record).</summary>
    public void Error(object subject, string? property, string message) => Complain(new(subject, property, message, true));

    /// <summary>Reports a warning about a record's property (by its C# name; null means the whole record).</summary>
    public void Warn(object subject, string? property, string message) => Complain(new(subject, property, message, false));

    /// <summary>True where a vector has a direction; where it does not, that is reported as an error about the property.</summary>
    public bool HasDirection(object subject, string property, Vector3 vector)
    {
        bool has = vector.Norm() > 0 && vector.Unit().IsFinite();
        if (!has)
        {
            Error(subject, property, $"the {property.ToLowerInvariant()} must have a length, but it is (or rounds to) [0, 0, 0]");
        }

        return has;
    }

    /// <summary>The texture that a record describes; the same record gives the same object.</summary>
    public Texture Texture(TextureDescription description)
    {
        Texture texture = ReadsNumbers ? Once(_numberTextures, description, Counted) : Once(description, Counted);
        _inputs |= texture.Inputs;
        _textures += _texturesIn.GetValueOrDefault(texture, 1);
        return texture;
    }

    /// <summary>
    /// As <see cref="Texture"/>, of one whose red channel counts as a number: pictures that do not say otherwise are read raw.
    /// </summary>
    public Texture NumberTexture(TextureDescription description)
    {
        bool before = ReadsNumbers;
        ReadsNumbers = true;
        Texture texture = Texture(description);
        ReadsNumbers = before;
        return texture;
    }

    /// <summary>As <see cref="Texture"/>, of one that shines: lights are sampled by uv, so that is all it may depend on.</summary>
    public Texture EmittedTexture(object subject, string property, TextureDescription description)
    {
        Texture texture = Texture(description);
        if ((texture.Inputs & TextureInputs.BeyondUv) != TextureInputs.None)
        {
            Error(subject, property, "the texture of a light must depend on uv: not noise, marble, wood or the colours of vertices");
        }

        return texture;
    }

    /// <summary>
    /// The material that a record describes; the same record gives the same object. For a shape that says nothing about its material, that
    /// of the group around it.
    /// </summary>
    public Material Material(MaterialDescription description) => _parts == 0 ? SurfaceMaterial(description) : Described(description);

    /// <summary>
    /// Loads the picture that a property of a record names; reports an error and returns a grey pixel if it cannot be read, and a warning
    /// and a stand-in if it is missing.
    /// </summary>
    public Picture Picture(object subject, string property, string path, bool raw)
    {
        try
        {
            return (loadPicture ?? throw new PictureException("there is nothing that reads pictures here"))(path, raw);
        }
        catch (PictureException e) when (e.IsMissing && !StandIn.IsError)
        {
            Warn(subject, property, $"{e.Message}: {(raw ? "a half is used" : StandIn.Words)}");
            return raw ? StandIn.Numbers : StandIn.Checks;
        }
        catch (PictureException e)
        {
            Error(subject, property, e.Message);
            return new Picture(1, 1, [0.5f, 0.5f, 0.5f]);
        }
    }

    /// <summary>
    /// Loads the model that a property of a record names; reports an error and returns null if it cannot be read, or has values out of
    /// their ranges.
    /// </summary>
    public ImportedModel? Model(object subject, string property, string path)
    {
        try
        {
            ImportedModel model = (loadModel ?? throw new ModelException("no reader for model files is registered"))(path);
            using (Within(subject, property))
            {
                return IsInRange(model.Scene) ? model : null;
            }
        }
        catch (ModelException e)
        {
            Error(subject, property, e.Message);
            return null;
        }
    }

    /// <summary>The medium that a record describes, null for empty space; the same record gives the same object.</summary>
    public Medium? Medium(MediumDescription description)
    {
        if (!_media.TryGetValue(description, out Medium? medium))
        {
            medium = description.Build(this);
            _media.Add(description, medium);
        }

        return medium;
    }

    /// <summary>Loads the grid that a property of a record names; reports an error and returns null if it cannot be read.</summary>
    internal VolumeGrid? Grid(object subject, string property, GridDescription grid)
    {
        try
        {
            return (loadGrid ?? throw new VolumeException("there is nothing that reads grids here"))(grid);
        }
        catch (VolumeException e)
        {
            Error(subject, property, e.Message);
            return null;
        }
    }

    /// <summary>Builds the scene, or returns null where <see cref="HasErrors"/> then says that it cannot be built.</summary>
    /// <param name="description">The scene to build.</param>
    public Scene? Build(SceneDescription description)
    {
        if (!IsInRange(description))
        {
            return null;
        }

        TakeNames(description);
        SphereLightSampling = description.Render.SphereLightSampling;
        Shutter = (description.Render.Shutter.X, description.Render.Shutter.Y);
        SceneAssembler assembler = new(this);
        foreach (ShapeDescription shape in description.Shapes)
        {
            assembler.Add(shape);
        }

        foreach (ShapeDescription light in description.Lights)
        {
            (int, int, int, int) before = assembler.World.Counts;
            int complaints = _complaints.Count;
            assembler.Add(light);
            if (!assembler.World.ShinesBeyond(before) && _complaints.Count == complaints)
            {
                Error(light, nameof(ShapeDescription.Material), "a shape under \"lights\" must shine: its material must be a luminaire");
            }
        }

        Scene? scene = Scene.Create(description, assembler.World, this);
        return HasErrors ? null : scene;
    }

    /// <summary>Returns true where all parameters of a record, and of its parts, are within their ranges; others are reported.</summary>
    internal bool IsInRange(object record) => (_ranges ??= new(Complain)).IsGood(record);

    /// <summary>The environment of a scene; null where it has a background.</summary>
    internal EnvironmentLight? Environment(SceneDescription scene)
    {
        if (scene.Environment is not null && !scene.Background.IsBlack)
        {
            Error(scene, nameof(SceneDescription.Background), "a scene has a background or an environment, but not both");
        }

        EnvironmentLight? environment = scene.Environment?.Build(this);
        if (environment is not null)
        {
            environment.Label = new(LightGroupLabel.Plain(scene.Environment!.LightGroup), "environment");
        }

        return environment;
    }

    /// <summary>
    /// The most shapes that rays are tested against one after the other, without a tree; null for what is fastest. Pictures are the same.
    /// </summary>
    internal int? LargestLoop { get; init; }

    /// <summary>True where the textures being built stand for numbers, so that pictures are read raw.</summary>
    internal bool ReadsNumbers { get; private set; }

    /// <summary>The times at which the shutter opens and closes, in seconds.</summary>
    internal (double Open, double Close) Shutter { get; private set; }

    /// <summary>
    /// The material of a shape's surface: what the model around it says, or else its own, or else that of the group around it.
    /// </summary>
    internal Material SurfaceMaterial(MaterialDescription description) =>
        Described(_replacement ?? (ReferenceEquals(description, ShapeDescription.DefaultMaterial) ? _inherited : description));

    /// <summary>Until the end of the scope, shapes that say nothing are made of this material, unless it says nothing itself.</summary>
    internal MaterialScope Inherit(MaterialDescription description)
    {
        MaterialDescription before = _inherited;
        _inherited = ReferenceEquals(description, ShapeDescription.DefaultMaterial) ? before : description;
        return new(() => _inherited = before);
    }

    /// <summary>The material that all is made of within a thing which names one for all that it shows; null where each keeps its own.</summary>
    internal MaterialDescription? ReplacementBy(MaterialDescription description) =>
        _replacement ?? (ReferenceEquals(description, ShapeDescription.DefaultMaterial) ? null : description);

    /// <summary>
    /// Until the end of the scope, shapes that say nothing are made of the default material, or all of one that replaces theirs.
    /// </summary>
    internal MaterialScope InheritNothing(MaterialDescription? replacing = null)
    {
        (MaterialDescription inherited, MaterialDescription? replacement) = (_inherited, _replacement);
        (_inherited, _replacement) = (ShapeDescription.DefaultMaterial, replacing);
        return new(() => (_inherited, _replacement) = (inherited, replacement));
    }

    /// <summary>Until the end of the scope, all shapes are made of this material, whatever they say.</summary>
    internal MaterialScope Replace(MaterialDescription description)
    {
        MaterialDescription? before = _replacement;
        _replacement = before ?? (ReferenceEquals(description, ShapeDescription.DefaultMaterial) ? _inherited : description);
        return new(() => _replacement = before);
    }

    /// <summary>
    /// Until the end of the scope, complaints are about a property of one record: what they are about comes from a file that it names.
    /// </summary>
    internal MaterialScope Within(object subject, string property)
    {
        (object Subject, string Property)? before = _source;
        _source = before ?? (subject, property);
        return new(() => _source = before);
    }

    /// <summary>Takes down the names of a scene's materials and objects.</summary>
    internal void TakeNames(SceneDescription scene)
    {
        foreach ((string name, object thing) in scene.Materials.Select(m => (m.Key, (object)m.Value)).Concat(scene.Objects.Select(o => (o.Key, (object)o.Value))))
        {
            _names.TryAdd(thing, name);
        }
    }

    /// <summary>The name of a material or an object; null where it has none.</summary>
    internal string? NameOf(object description) => _names.GetValueOrDefault(description);

    /// <summary>The record that a part of a scene counts as made from: for parts of a file, the record that names the file.</summary>
    internal ShapeDescription? SourceOf(ShapeDescription part) => KeepsSources ? _source?.Subject as ShapeDescription ?? part : null;

    /// <summary>The description that a material was made from; null where it is of another scene.</summary>
    internal object? DescriptionOf(Material material) => _built.FirstOrDefault(b => ReferenceEquals(b.Value, material)).Key;

    private Texture Counted(TextureDescription description)
    {
        int outer = _textures;
        _textures = 1;
        Texture texture = description.Build(this);
        if (_textures > MostTextures)
        {
            // A few of one another are millions, and each ray would ask them all.
            Error(description, null, $"the texture consists of more than {MostTextures} others, each counted as often as it is a part");
            texture = new SolidTexture(Rgb.Black);
            _textures = 1;
        }

        _texturesIn[texture] = _textures;
        _textures = outer;
        return texture;
    }

    // What a material's textures depend on, that around it depends on too.
    private Material Described(MaterialDescription description)
    {
        Material material = Once(description, Describe);
        _inputs |= material.Inputs;
        return material;
    }

    private Material Describe(MaterialDescription description)
    {
        _parts++;
        TextureInputs outer = _inputs;
        _inputs = TextureInputs.None;
        Material material = description.Build(this);
        if (material.Parts > Materials.Material.MostParts)
        {
            // A few nested mixes of one another are millions, and each ray would ask them all.
            Error(description, null, $"the material consists of more than {Materials.Material.MostParts} others, each counted as often as it is a part");
            material = new DiffuseMaterial(new SolidTexture(Rgb.Black));
        }

        material.Inputs = _inputs;
        _inputs = outer;
        _parts--;
        material.Source = KeepsSources ? description : null;
        material.Name = NameOf(description);
        return material;
    }

    // What comes from a file that a record names is said of that record, with what it is about where that would otherwise be lost.
    private void Complain(SceneComplaint complaint) => _complaints.Add(_source is not { } source ? complaint : complaint with
    {
        Subject = source.Subject,
        Property = source.Property,
        Message = complaint.IsOutOfRange ? $"{RecordType.Of(complaint.Subject.GetType()).NameInMessages} in the file: {complaint.Message}" : complaint.Message,
    });

    private TBuilt Once<TDescription, TBuilt>(TDescription description, Func<TDescription, TBuilt> build)
        where TDescription : class
        where TBuilt : class => Once(_built, description, build);

    private static TBuilt Once<TDescription, TBuilt>(Dictionary<object, object> known, TDescription description, Func<TDescription, TBuilt> build)
        where TDescription : class
        where TBuilt : class
    {
        if (!known.TryGetValue(description, out object? built))
        {
            built = build(description);
            known[description] = built;
        }

        return (TBuilt)built;
    }
}

/// <summary>Undoes a change of what a <see cref="SceneBuilder"/> takes for granted, at the end of a <c>using</c>.</summary>
internal readonly struct MaterialScope(Action undo) : IDisposable
{
    public void Dispose() => undo();
}
