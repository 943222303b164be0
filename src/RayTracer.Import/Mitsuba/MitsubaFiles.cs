namespace RayTracer.Import;

/// <summary>The places of the files that XML scenes name: beside the file that names them, beside those that include it, and where <c>path</c> says.</summary>
/// <param name="home">The folder of the scene as a whole.</param>
/// <param name="folders">The folders to look in, the first one first.</param>
internal sealed class MitsubaFiles(string home, IReadOnlyList<string> folders)
{
    private readonly List<string> _added = [];

    /// <summary>The folders to look in, the first one first.</summary>
    public IEnumerable<string> Folders => _added.Concat(folders);

    /// <summary>Looks in one more folder from now on, before the others.</summary>
    public void Add(string folder) => _added.Insert(0, folder);

    /// <summary>The folders for a file that one of these includes.</summary>
    public MitsubaFiles For(string folder) => new(home, [folder, .. Folders]);

    /// <summary>The path of a file or folder, in the first folder that has one; from the folder of the scene where none has.</summary>
    public string Resolve(string name)
    {
        string system = name.Replace('\\', '/');
        return Folders.Select(f => Path.Combine(f, system)).FirstOrDefault(Path.Exists) ?? Path.Combine(home, system);
    }

    /// <summary>The path of a file, relative to the folder of the scene where it is not whole, with slashes.</summary>
    public string Find(string name)
    {
        string system = name.Replace('\\', '/');
        if (Path.IsPathRooted(system))
        {
            return system;
        }

        string root = home.Length == 0 ? "." : home;
        return Path.GetRelativePath(root, Path.GetFullPath(Resolve(name))).Replace('\\', '/');
    }
}
