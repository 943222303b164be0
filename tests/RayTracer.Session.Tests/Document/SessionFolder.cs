using RayTracer.Session;

namespace RayTracer.Session.Tests;

/// <summary>A folder for the files of one test, with a user's folders in it; gone at the test's end.</summary>
internal sealed class SessionFolder : IDisposable
{
    public string FullName { get; } = Directory.CreateTempSubdirectory("raytracer-document-").FullName;

    public UserFolders User => new(this["state"], this["cache"], FullName);

    public string this[string name] => Path.Combine(FullName, name);

    public string Write(string name, string text)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(this[name])!);
        File.WriteAllText(this[name], text);
        return this[name];
    }

    public void Dispose() => Directory.Delete(FullName, recursive: true);
}
