using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Platform.Storage;
using RayTracer.Desktop.ViewModels;

namespace RayTracer.Desktop.Views;

/// <summary>The system's dialogs and clipboard.</summary>
/// <param name="window">The window that they belong to; asked for when they are needed.</param>
internal sealed class WindowServices(Func<MainWindow> window) : IWindowServices
{
    /// <inheritdoc/>
    public async Task<string?> ChooseFile(string title, string? folder, IReadOnlyList<string> extensions)
    {
        FilePickerOpenOptions options = new()
        {
            Title = title,
            SuggestedStartLocation = await FolderOf(folder),
            FileTypeFilter = extensions.Count == 0 ? null : [new FilePickerFileType(title) { Patterns = [.. extensions.Select(e => $"*.{e}")] }, FilePickerFileTypes.All],
        };
        return await Storage.OpenFilePickerAsync(options) is [var file, ..] ? file.TryGetLocalPath() : null;
    }

    /// <inheritdoc/>
    public async Task<string?> ChooseNewFile(string title, string? folder, string name)
    {
        FilePickerSaveOptions options = new()
        {
            Title = title,
            SuggestedStartLocation = await FolderOf(folder),
            SuggestedFileName = name,
            DefaultExtension = Path.GetExtension(name).TrimStart('.'),
            ShowOverwritePrompt = true,
        };
        return (await Storage.SaveFilePickerAsync(options))?.TryGetLocalPath();
    }

    /// <inheritdoc/>
    public Task CopyText(string text) => window().Clipboard!.SetTextAsync(text);

    /// <inheritdoc/>
    public Task CopyPicture(byte[] png)
    {
        DataObject data = new();
        data.Set(OperatingSystem.IsWindows() ? "PNG" : OperatingSystem.IsMacOS() ? "public.png" : "image/png", png);
        return window().Clipboard!.SetDataObjectAsync(data);
    }

    /// <inheritdoc/>
    public void Close() => window().CloseAnyway();

    private IStorageProvider Storage => TopLevel.GetTopLevel(window())!.StorageProvider;

    private async Task<IStorageFolder?> FolderOf(string? folder) => folder is null ? null : await Storage.TryGetFolderFromPathAsync(folder);
}
