using RayTracer.Description;

namespace RayTracer.Textbook;

/// <summary>Makes the texture of a record.</summary>
/// <param name="description">The record.</param>
/// <param name="isNumber">True where its red channel is a number: then pictures are read as they are.</param>
public delegate ITexture TextureMaker(TextureDescription description, bool isNumber = false);

/// <summary>The record of a material that a plug-in defines.</summary>
public interface IOwnMaterial
{
    /// <summary>Makes the material.</summary>
    /// <param name="texture">Makes the textures of its parameters.</param>
    IMaterial Make(TextureMaker texture);
}

/// <summary>The record of a shape that a plug-in defines.</summary>
public interface IOwnShape
{
    /// <summary>Makes the shape.</summary>
    IShape Make();
}

/// <summary>The name of an integrator that a plug-in defines.</summary>
public interface IOwnIntegrator
{
    /// <summary>Makes the integrator.</summary>
    /// <param name="render">The settings of the scene, with its limits of depth.</param>
    IIntegrator Make(RenderDescription render);
}
