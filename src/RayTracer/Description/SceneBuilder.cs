using System.Numerics;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Description;

/// <summary>A complaint about one parameter of one description record.</summary>
/// <param name="Subject">The record complained about.</param>
/// <param name="Property">The name of its C# property, or null for the record as a whole.</param>
/// <param name="Message">What is wrong and what was expected, in one sentence without a final stop.</param>
/// <param name="IsError">Whether the scene cannot be rendered; otherwise it is a warning.</param>
public sealed record SceneComplaint(object Subject, string? Property, string Message, bool IsError);

/// <summary>
/// Turns a <see cref="SceneDescription"/> into a renderable <see cref="Scene"/>. Every complaint is collected, none is
/// thrown, so that a scene's author sees all of them at once.
/// </summary>
/// <param name="loadPicture">
/// Loads the picture file of the given path (first argument, as in the scene file), decoded from sRGB unless the second
/// argument says that its numbers are to be taken raw. May throw <see cref="PictureException"/>.
/// </param>
public sealed class SceneBuilder(Func<string, bool, Picture> loadPicture)
{
    private readonly Dictionary<object, object> _built = new(ReferenceEqualityComparer.Instance);
    private readonly List<SceneComplaint> _complaints = [];

    /// <summary>How spheres that shine are sampled.</summary>
    public SphereLightSampling SphereLightSampling { get; private set; }

    /// <summary>All complaints so far, in the order in which they came up.</summary>
    public IReadOnlyList<SceneComplaint> Complaints => _complaints;

    /// <summary>Whether any complaint is an error.</summary>
    public bool HasErrors => _complaints.Exists(c => c.IsError);

    /// <summary>Reports an error about a record's property (by its C# name; null means the whole record).</summary>
    public void Error(object subject, string? property, string message) => _complaints.Add(new(subject, property, message, IsError: true));

    /// <summary>Reports a warning about a record's property (by its C# name; null means the whole record).</summary>
    public void Warn(object subject, string? property, string message) => _complaints.Add(new(subject, property, message, IsError: false));

    /// <summary>Whether a vector tells a direction; where it does not, that is reported as an error about the property.</summary>
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
    public Texture Texture(TextureDescription description) => Once(description, d => d.Build(this));

    /// <summary>The material that a record describes; the same record gives the same object.</summary>
    public Material Material(MaterialDescription description) => Once(description, d => d.Build(this));

    /// <summary>Loads the picture that a property of a record names; reports an error and returns a grey pixel if it cannot be read.</summary>
    public Picture Picture(object subject, string property, string path, bool raw)
    {
        try
        {
            return loadPicture(path, raw);
        }
        catch (PictureException e)
        {
            Error(subject, property, e.Message);
            return new Picture(1, 1, [0.5f, 0.5f, 0.5f]);
        }
    }

    /// <summary>Builds the scene, or returns null where <see cref="HasErrors"/> then says that it cannot be built.</summary>
    /// <param name="description">The scene to build.</param>
    public Scene? Build(SceneDescription description)
    {
        SphereLightSampling = description.Render.SphereLightSampling;
        List<Shape> shapes = [];
        foreach (ShapeDescription shape in description.Shapes)
        {
            AddShape(shapes, shape);
        }

        foreach (ShapeDescription light in description.Lights)
        {
            Shape? built = AddShape(shapes, light);
            if (built is not null && !built.Material.Emits)
            {
                Error(light, nameof(ShapeDescription.Material), "a shape under \"lights\" must shine: its material must be a luminaire");
            }
        }

        Scene? scene = Scene.Create(description, shapes, this);
        return HasErrors ? null : scene;
    }

    private Shape? AddShape(List<Shape> shapes, ShapeDescription description)
    {
        Shape? shape = description.Build(this);
        if (shape is not null)
        {
            if (shape.Material.Emits && !float.IsFinite(shape.Area) && !HasErrors)
            {
                Error(description, null, "the area of this light is too large a number to compute with");
            }

            shapes.Add(shape);
        }

        return shape;
    }

    private TBuilt Once<TDescription, TBuilt>(TDescription description, Func<TDescription, TBuilt> build)
        where TDescription : class
        where TBuilt : class
    {
        if (!_built.TryGetValue(description, out object? built))
        {
            built = build(description);
            _built[description] = built;
        }

        return (TBuilt)built;
    }
}
