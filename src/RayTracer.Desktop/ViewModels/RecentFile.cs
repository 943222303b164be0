using System.Windows.Input;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A file that was opened or saved lately.</summary>
/// <param name="Path">Its whole path.</param>
/// <param name="Open">Opens it.</param>
internal sealed record RecentFile(string Path, ICommand Open)
{
    /// <summary>Its name.</summary>
    public string Name => System.IO.Path.GetFileName(Path);
}
