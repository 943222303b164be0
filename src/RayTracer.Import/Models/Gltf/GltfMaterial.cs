using RayTracer.Description;

namespace RayTracer.Import;

/// <summary>A material of a glTF file in the terms of scenes.</summary>
/// <param name="Description">The nearest material that there is.</param>
/// <param name="UvSet">Which set of uv its textures use.</param>
/// <param name="IsLamp">Whether it shines more than a picture on a screen would (KHR_materials_emissive_strength), so that it lights the scene.</param>
internal sealed record GltfMaterial(MaterialDescription Description, int UvSet, bool IsLamp);
