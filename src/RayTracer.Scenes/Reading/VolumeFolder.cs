using RayTracer.Description;
using RayTracer.Media;

namespace RayTracer.Scenes;

/// <summary>Loads grids by paths relative to a folder, each only once.</summary>
internal sealed class VolumeFolder(string folder)
{
    private readonly Dictionary<(string Path, string Name, string Size, GridNumbers Numbers), VolumeGrid> _grids = [];

    /// <summary>Loads a grid.</summary>
    /// <param name="grid">The grid; its file as it is written in the scene file.</param>
    /// <exception cref="VolumeException">It cannot be read.</exception>
    public VolumeGrid Load(GridDescription grid)
    {
        string full = Path.GetFullPath(Path.Combine(folder, grid.File));
        (string, string, string, GridNumbers) key = (full, grid.Name, string.Join(' ', grid.Size), grid.Numbers);
        if (_grids.TryGetValue(key, out VolumeGrid? known))
        {
            return known;
        }

        try
        {
            if (FileSearch.Complaint(full) is { } complaint)
            {
                throw new VolumeException(complaint);
            }

            VolumeGrid read = VolumeFile.Read(full, grid);
            _grids.Add(key, read);
            return read;
        }
        catch (Exception e) when (e is VolumeException or IOException or UnauthorizedAccessException)
        {
            throw new VolumeException($"cannot read {Quotation.Of(grid.File)}: {e.Message.TrimEnd('.')}", e);
        }
    }
}
