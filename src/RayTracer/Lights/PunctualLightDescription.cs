using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Lights;

/// <summary>
/// Describes a light without extent. It stands among the shapes, so that groups, transforms, motions and instances place it as they place
/// them; but rays never meet it.
/// </summary>
public abstract record PunctualLightDescription : ShapeDescription
{
    /// <inheritdoc/>
    public override SketchKinds SketchedAs => SketchKinds.Light;

    /// <summary>Returns null: there is no shape.</summary>
    public sealed override Shape? Build(SceneBuilder builder) => null;

    /// <summary>Reports why it cannot be built at a place.</summary>
    /// <param name="place">The place of its own space in the space that it is put into.</param>
    /// <param name="builder">Takes the diagnostics.</param>
    public virtual void Check(in Transform place, SceneBuilder builder)
    {
        if (!ReferenceEquals(Material, DefaultMaterial))
        {
            builder.Error(this, nameof(Material), "a light without extent has no surface, so it cannot have a material");
        }
    }

    /// <summary>The picture through which it shines; null where there is none.</summary>
    /// <param name="builder">Builds textures and takes the diagnostics.</param>
    public virtual Texture? BuildPicture(SceneBuilder builder) => null;

    /// <summary>The light, once <see cref="Check"/> found nothing wrong.</summary>
    /// <param name="motion">The motion of its space in the world.</param>
    /// <param name="picture">What <see cref="BuildPicture"/> returned.</param>
    public abstract LightSource Create(Motion motion, Texture? picture);

    /// <summary>Reports it where a position is moved too far away.</summary>
    protected void CheckPosition(string property, Vector3 position, in Transform place, SceneBuilder builder)
    {
        if (!place.Point(position).IsFinite())
        {
            builder.Error(this, property, "the transform moves the light to numbers too large to compute with");
        }
    }

    /// <summary>Reports it where a direction upwards leaves open which way a picture is turned.</summary>
    protected void CheckUp(string property, Vector3 direction, Vector3 up, SceneBuilder builder)
    {
        if (!direction.Unit().Cross(up.Unit()).Unit().IsFinite())
        {
            builder.Error(this, property, $"{Quotation.Of(RecordType.Of(GetType()).Parameters.First(p => p.PropertyName == property).Key)} must not be zero or parallel to the light's direction");
        }
    }

    /// <summary>Reports it where a direction has no length, or becomes one of too little or too much of it.</summary>
    protected void CheckDirection(string property, Vector3 direction, in Transform place, SceneBuilder builder)
    {
        if (builder.HasDirection(this, property, direction) && !place.Vector(direction.Unit()).Unit().IsFinite())
        {
            builder.Error(this, property, "the transform turns the direction into numbers too large or too small to compute with");
        }
    }
}
