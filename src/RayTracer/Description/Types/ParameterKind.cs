namespace RayTracer.Description;

/// <summary>The forms that a parameter's value may have in a scene file.</summary>
public enum ParameterKind
{
    /// <summary>A number.</summary>
    Number,

    /// <summary>A whole number.</summary>
    Integer,

    /// <summary>true or false.</summary>
    Boolean,

    /// <summary>Text.</summary>
    Text,

    /// <summary>The path of a file, relative to the scene file's folder.</summary>
    File,

    /// <summary>One of a few words.</summary>
    Choice,

    /// <summary>Two numbers in brackets.</summary>
    Vector2,

    /// <summary>Three numbers in brackets.</summary>
    Vector3,

    /// <summary>A colour.</summary>
    Color,

    /// <summary>A texture, a colour, or a texture's name.</summary>
    Texture,

    /// <summary>A material or a material's name.</summary>
    Material,

    /// <summary>A list of materials or their names.</summary>
    Materials,

    /// <summary>A shape or the name of an object.</summary>
    Shape,

    /// <summary>A list of shapes.</summary>
    Shapes,

    /// <summary>An environment.</summary>
    Environment,

    /// <summary>An object of parameters.</summary>
    Record,

    /// <summary>A list of objects of parameters.</summary>
    Records,

    /// <summary>A list of numbers.</summary>
    Numbers,

    /// <summary>A list of whole numbers.</summary>
    Integers,

    /// <summary>A list of pairs of numbers.</summary>
    Vector2s,

    /// <summary>A list of triples of numbers.</summary>
    Vector3s,

    /// <summary>A list of triples of whole numbers.</summary>
    Triangles,

    /// <summary>Textures by their names.</summary>
    NamedTextures,

    /// <summary>Materials by their names.</summary>
    NamedMaterials,

    /// <summary>Shapes by their names.</summary>
    NamedShapes,
}
