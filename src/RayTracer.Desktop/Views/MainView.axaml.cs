using Avalonia.Controls;
using Avalonia.Input;
using RayTracer.Desktop.ViewModels;

namespace RayTracer.Desktop.Views;

/// <summary>The whole window's content.</summary>
internal sealed partial class MainView : UserControl
{
    /// <summary>Makes it.</summary>
    public MainView() => InitializeComponent();

    /// <summary>A key that nothing within has used.</summary>
    protected override void OnKeyDown(KeyEventArgs e)
    {
        base.OnKeyDown(e);
        if (e.Handled || DataContext is not MainViewModel { Dialog: null } main)
        {
            return;
        }

        // Where text is written, only keys with Ctrl or Alt are commands.
        HeldKeys held = Keyboard.Held(e.KeyModifiers);
        bool isPlain = !held.HasFlag(HeldKeys.Mod) && !held.HasFlag(HeldKeys.Alt);
        if (!(isPlain && e.Source is TextBox) && main.Commands.OfKeys(Keyboard.NameOf(e.Key, e.KeyModifiers), held) is { IsEnabled: true } command)
        {
            command.Execute(null);
            e.Handled = true;
        }
    }
}
