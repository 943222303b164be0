using RayTracer.Textures;

namespace RayTracer.Tests.Scenes;

/// <summary>Stands for the image readers.</summary>
internal static class TestPictures
{
    public static Picture Read(string path, bool raw) => new(1, 1, [1, raw ? 1 : 0, 0]);
}
