namespace RayTracer.Scenes;

/// <summary>What a scene file may write as the value of a parameter.</summary>
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

    /// <summary>A shape.</summary>
    Shape,

    /// <summary>A list of shapes.</summary>
    Shapes,

    /// <summary>An object of parameters.</summary>
    Record,

    /// <summary>Textures by their names.</summary>
    NamedTextures,

    /// <summary>Materials by their names.</summary>
    NamedMaterials,
}
