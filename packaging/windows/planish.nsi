; Installs Planish for the current user, without an administrator. The environment is left alone: Windows
; finds the program by its App Paths.
;
;   makensis -DVERSION=... -DLISTS=FOLDER -DOUTPUT=FILE planish.nsi
;
; LISTS has install.nsh and remove.nsh: what goes into the folder, file by file, so that the uninstaller
; removes that and nothing else.

Target amd64-unicode
Name "Planish"
OutFile "${OUTPUT}"
InstallDir "$LOCALAPPDATA\Programs\Planish"
RequestExecutionLevel user
SetCompressor /SOLID lzma
ShowInstDetails nevershow
ShowUninstDetails nevershow

VIProductVersion "${VERSION}.0"
VIAddVersionKey "ProductName" "Planish"
VIAddVersionKey "ProductVersion" "${VERSION}"
VIAddVersionKey "FileVersion" "${VERSION}"
VIAddVersionKey "FileDescription" "Installer of Planish"
VIAddVersionKey "LegalCopyright" "Apache License 2.0"

!include LogicLib.nsh
!include FileFunc.nsh

!define UNINSTALLERS "Software\Microsoft\Windows\CurrentVersion\Uninstall"
!define UNINSTALL "${UNINSTALLERS}\Planish"
!define APP_PATHS "Software\Microsoft\Windows\CurrentVersion\App Paths"
!define OF_FILES "Software\Classes\SystemFileAssociations"

Page directory
Page instfiles
UninstPage uninstConfirm
UninstPage instfiles

!macro AddVerb extension
  WriteRegStr HKCU "${OF_FILES}\${extension}\shell\Planish" "" "Flatten with Planish"
  WriteRegStr HKCU "${OF_FILES}\${extension}\shell\Planish\command" "" '"$INSTDIR\planish.exe" "%1"'
!macroend

; Keys that were there before, or that others need, are not empty.
!macro RemoveVerb extension
  DeleteRegKey HKCU "${OF_FILES}\${extension}\shell\Planish"
  DeleteRegKey /ifempty HKCU "${OF_FILES}\${extension}\shell"
  DeleteRegKey /ifempty HKCU "${OF_FILES}\${extension}"
!macroend

Function RefuseFoldersOfOthers
  ${If} ${FileExists} "$INSTDIR\uninstall.exe"
    Return
  ${EndIf}
  ${DirState} "$INSTDIR" $0
  ${If} $0 == 1
    MessageBox MB_OK|MB_ICONSTOP "$INSTDIR has files that are not of Planish. Choose an empty or a new folder." /SD IDOK
    SetErrorLevel 2
    Quit
  ${EndIf}
FunctionEnd

Section
  Call RefuseFoldersOfOthers
  ${GetParent} "$INSTDIR" $1
  ${DirState} "$1" $2  ; -1: Windows makes this folder only when it is first needed
  SetOutPath "$INSTDIR"
  !include "${LISTS}/install.nsh"
  WriteUninstaller "$INSTDIR\uninstall.exe"
  CreateShortcut "$SMPROGRAMS\Planish.lnk" "$INSTDIR\planish.exe"

  WriteRegStr HKCU "${APP_PATHS}\planish.exe" "" "$INSTDIR\planish.exe"
  !insertmacro AddVerb ".obj"
  !insertmacro AddVerb ".off"
  !insertmacro AddVerb ".ply"
  !insertmacro AddVerb ".stl"

  WriteRegStr HKCU "${UNINSTALL}" "DisplayName" "Planish"
  WriteRegStr HKCU "${UNINSTALL}" "DisplayVersion" "${VERSION}"
  WriteRegStr HKCU "${UNINSTALL}" "DisplayIcon" "$INSTDIR\planish.exe"
  WriteRegStr HKCU "${UNINSTALL}" "InstallLocation" "$INSTDIR"
  WriteRegStr HKCU "${UNINSTALL}" "UninstallString" '"$INSTDIR\uninstall.exe"'
  WriteRegStr HKCU "${UNINSTALL}" "QuietUninstallString" '"$INSTDIR\uninstall.exe" /S'
  WriteRegDWORD HKCU "${UNINSTALL}" "NoModify" 1
  WriteRegDWORD HKCU "${UNINSTALL}" "NoRepair" 1
  ${If} $2 == -1
    WriteRegDWORD HKCU "${UNINSTALL}" "MadeParent" 1
  ${EndIf}
SectionEnd

Section Uninstall
  ReadRegDWORD $2 HKCU "${UNINSTALL}" "MadeParent"
  ${un.GetParent} "$INSTDIR" $1
  SetOutPath "$TEMP"
  !include "${LISTS}/remove.nsh"
  Delete "$INSTDIR\uninstall.exe"
  RMDir "$INSTDIR"
  ${If} $2 == 1
    RMDir "$1"
  ${EndIf}
  Delete "$SMPROGRAMS\Planish.lnk"

  DeleteRegKey HKCU "${APP_PATHS}\planish.exe"
  DeleteRegKey /ifempty HKCU "${APP_PATHS}"
  !insertmacro RemoveVerb ".obj"
  !insertmacro RemoveVerb ".off"
  !insertmacro RemoveVerb ".ply"
  !insertmacro RemoveVerb ".stl"
  DeleteRegKey /ifempty HKCU "${OF_FILES}"
  DeleteRegKey HKCU "${UNINSTALL}"
  DeleteRegKey /ifempty HKCU "${UNINSTALLERS}"
SectionEnd
